// MuJoCo: one box on a free joint.
#include <array>
#include <cstring>
#include <mujoco/mujoco.h>
#include <sstream>

#include <Eigen/Geometry>

#include "base/error.h"
#include "engines/engine.h"

namespace rotatebook::bench {
namespace {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelHandle = std::unique_ptr<mjModel, DeleteModel>;
using DataHandle = std::unique_ptr<mjData, DeleteData>;

std::string modelText(const body::Cuboid& book) {
  const Eigen::Vector3d half = book.size / 2;
  std::ostringstream text;
  text.precision(17);
  text << "<mujoco><option gravity='0 0 0'/><worldbody><body><freejoint/><geom type='box' size='"
       << half.x() << ' ' << half.y() << ' ' << half.z() << "' mass='" << book.mass
       << "'/></body></worldbody></mujoco>";
  return text.str();
}

/// The library reads files alone; this one lies in its virtual file system.
ModelHandle loadModel(const std::string& text) {
  constexpr const char* kName = "book.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(text.size()));
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), kName)], text.data(), text.size());
  std::array<char, 500> problem{};
  ModelHandle model(
      mj_loadXML(kName, files.get(), problem.data(), static_cast<int>(problem.size())));
  mj_deleteVFS(files.get());
  if (!model) throw MachineError(std::string("MuJoCo does not take the book: ") + problem.data());
  return model;
}

class MujocoEngine final : public Engine {
 public:
  MujocoEngine(const Motion& motion, double step, mjtIntegrator integrator)
      : model_(loadModel(modelText(motion.book))), data_(mj_makeData(model_.get())) {
    model_->opt.timestep = step;
    model_->opt.integrator = integrator;
    // Of a free joint's velocities the first three are linear, in world axes; the others angular,
    // in body axes. At the start the two agree.
    Eigen::Map<Eigen::Vector3d>(data_->qvel + 3) = motion.angularVelocity;
  }

  void advance(int steps) override {
    for (int i = 0; i < steps; ++i) mj_step(model_.get(), data_.get());
  }

  EngineState state() const override {
    EngineState state;
    const mjtNum* q = data_->qpos + 3;
    state.worldFromBody = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
    const Eigen::Vector3d spinBody = Eigen::Map<const Eigen::Vector3d>(data_->qvel + 3);
    state.angularVelocity = state.worldFromBody * spinBody;
    return state;
  }

 private:
  ModelHandle model_;
  DataHandle data_;
};

Mode mode(const char* name, mjtIntegrator integrator) {
  return {name, [integrator](const Motion& motion, double step) {
            return std::make_unique<MujocoEngine>(motion, step, integrator);
          }};
}

}  // namespace

Family mujocoFamily() {
  Family family;
  family.name = std::string("MuJoCo ") + mj_versionString();
  family.package = "libmujoco-dev";
  static_assert(sizeof(mjtNum) == sizeof(double));
  family.note = "double precision";
  family.modes = {
      mode("default: Euler", mjINT_EULER),
      mode("RK4", mjINT_RK4),
      mode("implicit", mjINT_IMPLICIT),
  };
  return family;
}

}  // namespace rotatebook::bench
