#include "plot/drawing.h"

#include <algorithm>
#include <array>
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cmath>
#include <map>
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

void require(cairo_status_t status, const char* what) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw MachineError(std::string("Cairo can't draw ") + what + ": " +
                     cairo_status_to_string(status));
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

/// Returns the SVG with the numbers of its surfaces in their order: Cairo counts all that the
/// process has made.
std::string renumbered(const std::string& svg) {
  static constexpr std::string_view kName = "surface", kDigits = "0123456789";
  std::map<std::string, std::size_t> numbers;
  std::string text;
  std::size_t done = 0;
  for (std::size_t at = svg.find(kName); at != svg.npos; at = svg.find(kName, done)) {
    const std::size_t begin = at + kName.size(), end = svg.find_first_not_of(kDigits, begin);
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
  return renumbered(bytes);
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
  return bytes;
}

/// A format of plots' files; each plot is written in all.
struct FormatRow {
  std::string_view ending;
  std::string (*bytesOf)(const Drawing& drawing, const Surface& sheet, double scale);
};
constexpr std::array<FormatRow, 3> kFormats{{{".png", pngOf}, {".svg", svgOf}, {".pdf", pdfOf}}};

}  // namespace

struct Drawing::Parts {
  Parts(const Box& box, overlay::Typesetter letters)
      : sheet(box), type(std::move(letters)), canvas(cairo.get()) {}

  Box sheet;
  overlay::Typesetter type;
  cairo_rectangle_t extents{0, 0, sheet.width, sheet.height};
  Surface surface{cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &extents)};
  Cairo cairo{cairo_create(surface.get())};
  overlay::Canvas canvas;
  std::vector<Written> texts;
};

Drawing::Drawing(double width, double height, const Colour& ground, overlay::Typesetter type)
    : parts_(std::make_unique<Parts>(Box{0, 0, width, height}, std::move(type))) {
  cairo_set_source_rgb(parts_->cairo.get(), ground.red, ground.green, ground.blue);
  cairo_paint(parts_->cairo.get());
}
Drawing::Drawing(Drawing&&) noexcept = default;
Drawing::~Drawing() = default;

const Box& Drawing::sheet() const {
  return parts_->sheet;
}

const overlay::Typesetter& Drawing::type() const {
  return parts_->type;
}

overlay::Canvas& Drawing::canvas() {
  return parts_->canvas;
}

void Drawing::picture(const image::Image& picture, const Box& box) {
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width(), picture.height()));
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* to = rowOf(surface, y);
    for (int i = 0; i < 3 * picture.width(); ++i) to[i / 3 * 4 + 2 - i % 3] = picture.row(y)[i];
  }
  cairo_surface_mark_dirty(surface.get());
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
  Box box = boxOf(parts_->type, text, style, width);
  box = box.moved(position - anchor.cwiseProduct(Point(box.width, box.height)));
  if (text.empty()) return box;
  parts_->type.draw(text, style, static_cast<int>(width), parts_->cairo.get(), {box.x, box.y});
  parts_->texts.push_back({text, box});
  return box;
}

const std::vector<Written>& Drawing::texts() const {
  return parts_->texts;
}

image::Image Drawing::pixels(double scale) const {
  image::Image picture(static_cast<int>(std::lround(scale * sheet().width)),
                       static_cast<int>(std::lround(scale * sheet().height)),
                       image::PixelFormat::Rgb8);
  const Surface target(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width(), picture.height()));
  paintOnto(target, parts_->surface, scale, "a picture");
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* from = rowOf(target, y);
    for (int i = 0; i < 3 * picture.width(); ++i) picture.row(y)[i] = from[i / 3 * 4 + 2 - i % 3];
  }
  return picture;
}

std::string Drawing::file(std::string_view ending, double scale) const {
  const auto* const format = std::ranges::find(kFormats, ending, &FormatRow::ending);
  return format->bytesOf(*this, parts_->surface, scale);
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
  for (const std::filesystem::path& file : files) {
    system::writeFileAtomically(file, drawing.file(file.extension().string(), scale));
  }
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
