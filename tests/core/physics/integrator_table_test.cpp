#include "physics/integrators/integrator_table.h"

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "physics/integrators/runge_kutta.h"
#include "physics/integrators/verlet.h"
#include "physics/rigid_simulator.h"

namespace rotatebook::physics {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct NotStepping {
  static constexpr bool kMomentumInBody = true;
  NotStepping(const RigidConstants&, double) {}
  void step(RigidState<Eigen::Quaterniond>&) const {}  // no matrix
};

static_assert(RigidIntegrator<RungeKutta4> && !RigidIntegrator<Verlet>);
static_assert(ParticleIntegrator<Verlet> && !ParticleIntegrator<RungeKutta4>);
static_assert(!RigidIntegrator<NotStepping>);

TEST(IntegratorTable, IsInTheOrderOfTheEnumeration) {
  ASSERT_EQ(integratorTable().size(), kIntegratorNames.size());
  std::set<std::string_view> words;
  for (std::size_t i = 0; i < integratorTable().size(); ++i) {
    EXPECT_EQ(integratorTable()[i].integrator, static_cast<Integrator>(i));
    EXPECT_EQ(integratorTable()[i].word, kIntegratorNames[i]);
    words.insert(kIntegratorNames[i]);
  }
  EXPECT_EQ(words.size(), kIntegratorNames.size());
}

TEST(IntegratorTable, HasTheIntegratorsOfEachModel) {
  EXPECT_THAT(integratorsOf(Model::Particles),
              ElementsAre(Integrator::Euler, Integrator::Rk4, Integrator::SymplecticEuler,
                          Integrator::Verlet));
  EXPECT_EQ(integratorsOf(Model::Matrix), integratorsOf(Model::Quaternion));
  EXPECT_EQ(integratorsOf(Model::Matrix).size(), 14u);
  EXPECT_THAT(integratorsOf(Model::Exact), IsEmpty());
  EXPECT_TRUE(isFor(Model::Matrix, Integrator::Dmv6));
  EXPECT_FALSE(isFor(Model::Particles, Integrator::Dmv6));
  EXPECT_FALSE(isFor(Model::Matrix, Integrator::Verlet));
  EXPECT_FALSE(isFor(Model::Exact, Integrator::Euler));
}

/// The lines of docs/motion.md that begin as rows of its table of integrators do.
std::vector<std::string> documentedRows() {
  std::ifstream file(std::string(ROTATEBOOK_SOURCE) + "/docs/motion.md");
  std::vector<std::string> rows;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("| `simulation.integrator` | order |")) inside = true;
    if (line.empty()) inside = false;
    if (inside && line.starts_with("| `") && !line.starts_with("| `simulation")) {
      rows.push_back(line);
    }
  }
  return rows;
}

std::string documented(const IntegratorRow& row, const Stepping& stepping) {
  std::ostringstream text;
  text << "| `" << row.word << "` | " << row.order << " | " << stepping.keeps << " | "
       << stepping.nanoseconds << " | " << stepping.source << " |";
  return text.str();
}

TEST(IntegratorTable, IsTheOneInTheDocumentation) {
  std::vector<std::string> rows;
  for (const Model model : {Model::Quaternion, Model::Particles}) {
    for (const Integrator integrator : integratorsOf(model)) {
      rows.push_back(documented(integratorTable()[static_cast<std::size_t>(integrator)],
                                *steppingOf(model, integrator)));
    }
  }
  EXPECT_EQ(documentedRows(), rows);
}

}  // namespace
}  // namespace rotatebook::physics
