#include "diagnose/reference_picture.h"

#include <Eigen/Geometry>

#include "embedded/diagnose.h"
#include "image/png_file.h"

namespace rotatebook::diagnose {

render::RenderSettings referencePictureSettings() {
  render::RenderSettings settings;
  settings.width = 96;
  settings.height = 54;
  settings.camera.position = {0, 0, 0.62};
  return settings;
}

body::Cage referencePictureBook() {
  const Eigen::AngleAxisd left(0.6, Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd forward(0.35, Eigen::Vector3d::UnitX());
  return (forward * left).toRotationMatrix() * body::Cuboid{}.corners();
}

image::Image drawReferencePicture(const render::BookTextures& textures,
                                  const render::DeviceChoice& choice) {
  render::RenderSettings settings = referencePictureSettings();
  settings.device = choice;
  render::Renderer renderer(settings, textures);
  image::Image picture = renderer.makePicture();
  renderer.draw(referencePictureBook(), picture);
  return picture;
}

image::Image storedReferencePicture() {
  return image::decodePng(referencePicturePng(), "stored reference picture");
}

}  // namespace rotatebook::diagnose
