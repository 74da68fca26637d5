#include "overlay/marks.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "overlay/layout.h"
#include "overlay/mark.h"
#include "overlay/notes.h"

namespace rotatebook::overlay {
namespace {

using scene::Overlay;

}  // namespace

struct Marks::Parts {
  Parts(const scene::Scene& asked, const physics::Trajectory& motion, const Ground& ground)
      : scene(asked),
        trajectory(motion),
        type(Typesetter::of(asked.overlay.font)),
        scale(ground.width, ground.height),
        canvas(ground.width, ground.height) {
    taken.push_back(ground.corner);
    addWordsAtTheTop(ground);
    layout = layOut(scale, wanted(ground));
    taken.push_back({0, 1.0 * (ground.height - layout.bottomRows), 1.0 * ground.width,
                     1.0 * layout.bottomRows});
    if (motion.divergedAt) notice = divergenceNotice(context(), *motion.divergedAt, taken);
  }

  MarkContext context() const { return {scene, trajectory, type, scale}; }

  bool shows(Overlay overlay) const { return scene::shows(scene, overlay); }

  Wanted wanted(const Ground& ground) const {
    Wanted all;
    all.bottomRows = ground.bottomRows;
    return all;
  }

  /// From the top left: the ground's other words, its label, the count of half-turns.
  void addWordsAtTheTop(const Ground& ground) {
    Point place(scale.margin, scale.margin);
    if (!ground.corner.empty()) {
      place = {ground.corner.x, ground.corner.bottom() + 0.3 * scale.letters};
    }
    if (!ground.label.empty()) {
      plates.push_back(labelPlate(context(), ground.label, place, scale.width - 2 * scale.margin));
      taken.push_back(plates.back().texts.front());
      place.y() = taken.back().bottom() + 0.3 * scale.letters;
    }
    if (shows(Overlay::HalfTurns)) {
      auto count = std::make_unique<HalfTurns>(context(), place);
      taken.push_back(count->box());
      insets.push_back(std::move(count));
    }
  }

  void draw(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld, image::Image& picture) {
    const std::int64_t last = static_cast<std::int64_t>(trajectory.samples.size()) - 1;
    const bool ended = frame > last;
    frame = std::min(frame, last);
    const physics::Sample sample =
        physics::seenFrom(scene.camera.frame, trajectory.samples[static_cast<std::size_t>(frame)]);
    const View view{frame,  sample, Projector(clipFromWorld, scale.width, scale.height),
                    canvas, labels, picture};
    canvas.forgetTexts();
    for (const auto& mark : inWorld) mark->draw(view);
    for (const Plate& plate : plates) canvas.lay(plate, picture);
    for (const auto& mark : insets) mark->draw(view);
    std::vector<Box> boxes = taken;
    if (ended && notice) {
      canvas.lay(*notice, picture);
      boxes.push_back(notice->texts.front());
    }
    labels.write(canvas, {0, 0, 1.0 * scale.width, 1.0 * scale.height}, std::move(boxes));
    canvas.layOver(picture);
  }

  scene::Scene scene;
  const physics::Trajectory& trajectory;
  Typesetter type;
  Scale scale;
  Canvas canvas;
  Labels labels;
  Layout layout;
  std::vector<Box> taken;     // where no moving words may be
  std::vector<Plate> plates;  // what is the same in every frame
  std::optional<Plate> notice;
  std::vector<std::unique_ptr<Mark>> inWorld;  // on and about the book, the lowest first
  std::vector<std::unique_ptr<Mark>> insets;   // above them
};

Marks::Marks(const scene::Scene& scene, const physics::Trajectory& trajectory, const Ground& ground)
    : parts_(std::make_unique<Parts>(scene, trajectory, ground)) {}
Marks::~Marks() = default;
Marks::Marks(Marks&&) noexcept = default;
Marks& Marks::operator=(Marks&&) noexcept = default;

int Marks::bottomRows() const {
  return parts_->layout.bottomRows;
}

void Marks::draw(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld, image::Image& picture) {
  parts_->draw(frame, clipFromWorld, picture);
}

const std::vector<Box>& Marks::texts() const {
  return parts_->canvas.texts();
}

}  // namespace rotatebook::overlay
