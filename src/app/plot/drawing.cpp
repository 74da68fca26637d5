#include "plot/drawing.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.h"
#include "image/png_file.h"
#include "plot/plot_files.h"
#include "system/atomic_file.h"

namespace rotatebook::plot {
namespace {

struct Deleter {
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Cairo = std::unique_ptr<cairo_t, Deleter>;
using Surface = std::unique_ptr<cairo_surface_t, Deleter>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void setColour(cairo_t* cairo, const Colour& colour, double opacity = 1) {
  cairo_set_source_rgba(cairo, colour.red, colour.green, colour.blue, opacity);
}

void require(cairo_status_t status, const char* what) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw MachineError(std::string("Cairo can't draw ") + what + ": " +
                     cairo_status_to_string(status));
}

/// Paints `sheet` onto `target`, and completes that.
void paintOnto(const Surface& target, cairo_surface_t* sheet, double scale, const char* what) {
  const Cairo cairo(cairo_create(target.get()));
  cairo_scale(cairo.get(), scale, scale);
  cairo_set_source_surface(cairo.get(), sheet, 0, 0);
  cairo_paint(cairo.get());
  require(cairo_status(cairo.get()), what);
  cairo_surface_finish(target.get());
  require(cairo_surface_status(target.get()), what);
}

/// Returns the picture as Cairo has it.
Surface surfaceOf(const image::Image& picture) {
  Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width(), picture.height()));
  const int bytes = bytesPerPixel(picture.format());
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* from = picture.row(y);
    std::uint8_t* to =
        cairo_image_surface_get_data(surface.get()) +
        static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface.get());
    for (int x = 0; x < picture.width(); ++x, from += bytes, to += 4) {
      for (int channel = 0; channel < 3; ++channel) to[channel] = from[2 - channel];
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

}  // namespace

struct Drawing::Parts {
  Parts(double w, double h, overlay::Typesetter letters)
      : width(w), height(h), type(std::move(letters)) {
    const cairo_rectangle_t sheet{0, 0, w, h};
    surface.reset(cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &sheet));
    cairo.reset(cairo_create(surface.get()));
    cairo_set_line_cap(cairo.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo.get(), CAIRO_LINE_JOIN_ROUND);
  }

  void stroke(const Pen& pen) const {
    setColour(cairo.get(), pen.colour, pen.opacity);
    cairo_set_line_width(cairo.get(), pen.width);
    cairo_stroke(cairo.get());
  }
  void fill(const Colour& colour) const {
    setColour(cairo.get(), colour);
    cairo_fill(cairo.get());
  }

  double width, height;
  overlay::Typesetter type;
  Surface surface;
  Cairo cairo;
  std::vector<Written> texts;
};

Drawing::Drawing(double width, double height, const Colour& ground, overlay::Typesetter type)
    : parts_(std::make_unique<Parts>(width, height, std::move(type))) {
  setColour(parts_->cairo.get(), ground);
  cairo_paint(parts_->cairo.get());
}
Drawing::Drawing(Drawing&&) noexcept = default;
Drawing::~Drawing() = default;

double Drawing::width() const {
  return parts_->width;
}

double Drawing::height() const {
  return parts_->height;
}

void Drawing::line(std::span<const Point> points, const Pen& pen) {
  for (const Point& point : points) cairo_line_to(parts_->cairo.get(), point.x(), point.y());
  parts_->stroke(pen);
}

void Drawing::lines(std::span<const Point> pairs, const Pen& pen) {
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    cairo_move_to(parts_->cairo.get(), pairs[i].x(), pairs[i].y());
    cairo_line_to(parts_->cairo.get(), pairs[i + 1].x(), pairs[i + 1].y());
  }
  parts_->stroke(pen);
}

void Drawing::area(std::span<const Point> corners, const Colour& colour) {
  for (const Point& point : corners) cairo_line_to(parts_->cairo.get(), point.x(), point.y());
  parts_->fill(colour);
}

void Drawing::disc(const Point& centre, double radius, const Colour& colour) {
  cairo_arc(parts_->cairo.get(), centre.x(), centre.y(), radius, 0, 2 * std::numbers::pi);
  parts_->fill(colour);
}

void Drawing::roundedBox(const Box& box, double radius, const Colour& colour) {
  constexpr double kRight = std::numbers::pi / 2;
  cairo_t* cairo = parts_->cairo.get();
  cairo_arc(cairo, box.right() - radius, box.y + radius, radius, -kRight, 0);
  cairo_arc(cairo, box.right() - radius, box.bottom() - radius, radius, 0, kRight);
  cairo_arc(cairo, box.x + radius, box.bottom() - radius, radius, kRight, 2 * kRight);
  cairo_arc(cairo, box.x + radius, box.y + radius, radius, 2 * kRight, 3 * kRight);
  parts_->fill(colour);
}

void Drawing::picture(const image::Image& picture, const Box& box) {
  const Surface surface = surfaceOf(picture);
  cairo_t* cairo = parts_->cairo.get();
  cairo_save(cairo);
  cairo_translate(cairo, box.x, box.y);
  cairo_scale(cairo, box.width / picture.width(), box.height / picture.height());
  cairo_set_source_surface(cairo, surface.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
  cairo_rectangle(cairo, 0, 0, picture.width(), picture.height());
  cairo_fill(cairo);
  cairo_restore(cairo);
}

Box Drawing::write(const std::string& text, const TextStyle& style, const Point& position,
                   const Point& anchor, double width) {
  if (text.empty()) return {position.x(), position.y(), 0, 0};
  const int room = static_cast<int>(width);
  const overlay::TextSize size = sizeOf(text, style, width);
  const Box box{position.x() - anchor.x() * size.width, position.y() - anchor.y() * size.height,
                1.0 * size.width, 1.0 * size.height};
  parts_->type.draw(text, style, room, parts_->cairo.get(), {box.x, box.y});
  parts_->texts.push_back({text, box});
  return box;
}

overlay::TextSize Drawing::sizeOf(const std::string& text, const TextStyle& style,
                                  double width) const {
  return parts_->type.measure(text, style, static_cast<int>(width));
}

const std::vector<Written>& Drawing::texts() const {
  return parts_->texts;
}

image::Image Drawing::pixels(double scale) const {
  image::Image picture(static_cast<int>(std::lround(scale * width())),
                       static_cast<int>(std::lround(scale * height())), image::PixelFormat::Rgb8);
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width(), picture.height()));
  {
    const Cairo cairo(cairo_create(surface.get()));
    cairo_scale(cairo.get(), scale, scale);
    cairo_set_source_surface(cairo.get(), parts_->surface.get(), 0, 0);
    cairo_paint(cairo.get());
    require(cairo_status(cairo.get()), "a picture");
  }
  cairo_surface_flush(surface.get());
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* from =
        cairo_image_surface_get_data(surface.get()) +
        static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface.get());
    std::uint8_t* to = picture.row(y);
    for (int x = 0; x < picture.width(); ++x, from += 4, to += 3) {
      for (int channel = 0; channel < 3; ++channel) to[channel] = from[2 - channel];
    }
  }
  return picture;
}

std::string Drawing::png(double scale) const {
  return image::PngWriter().encode(pixels(scale).view(), "a plot");
}

std::string Drawing::svg(double) const {
  std::string bytes;
  const Surface target(cairo_svg_surface_create_for_stream(append, &bytes, width(), height()));
  cairo_svg_surface_set_document_unit(target.get(), CAIRO_SVG_UNIT_PX);
  paintOnto(target, parts_->surface.get(), 1, "an SVG");
  return bytes;
}

std::string Drawing::pdf(double) const {
  constexpr double kPoints = 72.0 / 96;  // a pixel
  std::string bytes;
  const Surface target(
      cairo_pdf_surface_create_for_stream(append, &bytes, kPoints * width(), kPoints * height()));
  // Without a date the same plot has the same bytes.
  cairo_pdf_surface_set_metadata(target.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  paintOnto(target, parts_->surface.get(), kPoints, "a PDF");
  return bytes;
}

std::vector<std::filesystem::path> plotFiles(const std::filesystem::path& stem) {
  std::vector<std::filesystem::path> files;
  for (const FormatRow& format : kFormats) {
    files.push_back(stem.string() + std::string(format.ending));
  }
  return files;
}

void writePlot(const Drawing& drawing, const std::vector<std::filesystem::path>& files,
               double scale) {
  for (std::size_t i = 0; i < kFormats.size(); ++i) {
    system::writeFileAtomically(files[i], (drawing.*kFormats[i].bytes)(scale));
  }
}

overlay::Typesetter lettersOf(const scene::Scene& scene) {
  return overlay::Typesetter::of(scene, overlay::Ink());
}

void requireLetters(const scene::Scene& scene, const std::vector<std::string>& texts) {
  Drawing sheet(1, 1, {}, lettersOf(scene));
  for (const std::string& text : texts) sheet.write(text, {}, Point(0, 0));
}

}  // namespace rotatebook::plot
