#include "plot/drawing.h"

#include <algorithm>
#include <array>
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "image/png_file.h"

namespace rotatebook::plot {
namespace {

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) try {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
} catch (const std::exception&) {
  return CAIRO_STATUS_NO_MEMORY;
}

void require(cairo_status_t status, const char* what) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw MachineError(fmt::format("can't draw {}: {}", what, cairo_status_to_string(status)));
}

/// Paints `sheet` onto `target`, and completes that.
void paintOnto(const Surface& target, const Surface& sheet, double scale, const char* what) {
  const Cairo cairo(cairo_create(target.get()));
  cairo_scale(cairo.get(), scale, scale);
  cairo_set_source_surface(cairo.get(), sheet.get(), 0, 0);
  cairo_paint(cairo.get());
  cairo_show_page(cairo.get());
  require(cairo_status(cairo.get()), what);
  cairo_surface_flush(target.get());
}

/// Returns the SVG with the numbers of its parts called `name` in their order: Cairo counts all
/// that the process has made.
std::string renumbered(const std::string& svg, std::string_view name) {
  std::map<std::string, std::size_t> numbers;
  std::string text;
  std::size_t done = 0;
  for (std::size_t at = svg.find(name); at != svg.npos; at = svg.find(name, done)) {
    const std::size_t begin = at + name.size();
    const std::size_t end = svg.find_first_not_of("0123456789", begin);
    text += svg.substr(done, begin - done);
    done = svg[at - 1] == '"' || svg[at - 1] == '#' ? end : begin;
    if (done == begin) continue;
    text += std::to_string(
        numbers.try_emplace(svg.substr(begin, end - begin), numbers.size()).first->second);
  }
  return text + svg.substr(done);
}

std::uint8_t* rowOf(const Surface& image, int y) {
  return cairo_image_surface_get_data(image.get()) +
         static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(image.get());
}

std::string pngOf(const Drawing& drawing, const Surface&, double scale) {
  return image::PngWriter().encode(drawing.pixels(scale).view(), "a plot");
}

std::string svgOf(const Drawing& drawing, const Surface& sheet, double) {
  std::string bytes;
  const Surface target(cairo_svg_surface_create_for_stream(append, &bytes, drawing.sheet().width,
                                                           drawing.sheet().height));
  cairo_svg_surface_set_document_unit(target.get(), CAIRO_SVG_UNIT_PX);
  paintOnto(target, sheet, 1, "an SVG");
  cairo_surface_finish(target.get());
  require(cairo_surface_status(target.get()), "an SVG");
  return renumbered(renumbered(bytes, "surface"), "image");
}

std::string pdfOf(const Drawing& drawing, const Surface& sheet, double) {
  constexpr double kPoints = 72.0 / 96;  // a pixel
  std::string bytes;
  const Surface target(cairo_pdf_surface_create_for_stream(
      append, &bytes, kPoints * drawing.sheet().width, kPoints * drawing.sheet().height));
  // Without a date the same plot has the same bytes.
  cairo_pdf_surface_set_metadata(target.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  paintOnto(target, sheet, kPoints, "a PDF");
  cairo_surface_finish(target.get());
  require(cairo_surface_status(target.get()), "a PDF");
  return bytes;
}

/// A format of plots' files; each plot is written in all.
struct FormatRow {
  std::string_view ending;
  std::string (*bytesOf)(const Drawing& drawing, const Surface& sheet, double scale);
};
constexpr std::array<FormatRow, 3> kFormats{{{".png", pngOf}, {".svg", svgOf}, {".pdf", pdfOf}}};

}  // namespace

void Deleter::operator()(_cairo* cairo) const {
  cairo_destroy(cairo);
}

void Deleter::operator()(_cairo_surface* surface) const {
  cairo_surface_destroy(surface);
}

Drawing::Drawing(double width, double height, const Colour& ground, overlay::Typesetter type)
    : sheet_{0, 0, width, height}, type_(std::move(type)) {
  const cairo_rectangle_t extents{0, 0, width, height};
  surface_.reset(cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &extents));
  cairo_.reset(cairo_create(surface_.get()));
  canvas_ = std::make_unique<overlay::Canvas>(cairo_.get());
  cairo_set_source_rgb(cairo_.get(), ground.red, ground.green, ground.blue);
  cairo_paint(cairo_.get());
}

void Drawing::picture(const image::Image& picture, const Box& box) {
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width(), picture.height()));
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* to = rowOf(surface, y);
    for (int i = 0; i < 3 * picture.width(); ++i) to[i / 3 * 4 + 2 - i % 3] = picture.row(y)[i];
  }
  cairo_surface_mark_dirty(surface.get());
  cairo_t* cairo = cairo_.get();
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
  Box box = boxOf(type_, text, style, width);
  box = box.moved(position - anchor.cwiseProduct(Point(box.width, box.height)));
  if (text.empty()) return box;
  type_.draw(text, style, static_cast<int>(width), cairo_.get(), {box.x, box.y});
  texts_.push_back({text, box});
  return box;
}

image::Image Drawing::pixels(double scale) const {
  image::Image picture(static_cast<int>(std::lround(scale * sheet().width)),
                       static_cast<int>(std::lround(scale * sheet().height)),
                       image::PixelFormat::Rgb8);
  const Surface target(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width(), picture.height()));
  paintOnto(target, surface_, scale, "a picture");
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* from = rowOf(target, y);
    for (int i = 0; i < 3 * picture.width(); ++i) picture.row(y)[i] = from[i / 3 * 4 + 2 - i % 3];
  }
  return picture;
}

std::string Drawing::file(std::string_view ending, double scale) const {
  const auto* const format = std::ranges::find(kFormats, ending, &FormatRow::ending);
  return format->bytesOf(*this, surface_, scale);
}

std::vector<PlotFile> filesOf(const Drawing& drawing,
                              const std::vector<std::filesystem::path>& files, double scale) {
  std::vector<PlotFile> plotted;
  for (const std::filesystem::path& file : files)
    plotted.push_back({file, drawing.file(file.extension().string(), scale)});
  return plotted;
}

Box boxOf(const overlay::Typesetter& type, const std::string& text, const TextStyle& style,
          double width) {
  if (text.empty()) return {};
  const overlay::TextSize size = type.measure(text, style, static_cast<int>(width));
  return {0, 0, 1.0 * size.width, 1.0 * size.height};
}

overlay::Typesetter lettersOf(const scene::Scene& scene) {
  return overlay::Typesetter::of(scene, overlay::Ink());
}

}  // namespace rotatebook::plot
