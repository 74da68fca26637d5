#include "physics/integrators/implicit_step.h"

#include <string>

#include "base/number_text.h"
#include "physics/integrators/step_error.h"

namespace rotatebook::physics {

void throwNoConvergence(const char* integrator, double h) {
  throw NoConvergence(std::string("the integrator ") + integrator +
                      " finds no solution for a step of " + roundedText(h, 4) +
                      " s: so long a step may have none; use shorter steps (more substeps)");
}

}  // namespace rotatebook::physics
