#include "overlay/text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fontconfig/fontconfig.h>
#include <pango/pangocairo.h>
#include <pango/pangofc-fontmap.h>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "embedded/overlay.h"
#include "overlay/cairo_handles.h"
#include "overlay/palette.h"
#include "scene/source_locations.h"
#include "system/file_descriptor.h"

namespace rotatebook::overlay {
namespace {

constexpr const char* kShippedFamily = "Inter";

using FontConfig = std::unique_ptr<FcConfig, Deleter<&FcConfigDestroy>>;
using FontMap = std::unique_ptr<PangoFontMap, Deleter<&g_object_unref>>;
using Context = std::unique_ptr<PangoContext, Deleter<&g_object_unref>>;
using LayoutPointer = std::unique_ptr<PangoLayout, Deleter<&g_object_unref>>;
using FontOptions = std::unique_ptr<cairo_font_options_t, Deleter<&cairo_font_options_destroy>>;
using Description = std::unique_ptr<PangoFontDescription, Deleter<&pango_font_description_free>>;
using LayoutIterator = std::unique_ptr<PangoLayoutIter, Deleter<&pango_layout_iter_free>>;
using Attributes = std::unique_ptr<PangoAttrList, Deleter<&pango_attr_list_unref>>;

constexpr double kLetterHaloOpacity = 0.8;

/// A font file in memory, which has a path because fontconfig takes only paths.
class FontFile {
 public:
  explicit FontFile(std::string_view bytes) : file_(system::createMemoryFile("font")) {
    system::writeAll(file_, bytes, "the font in memory");
  }

  std::string path() const { return fmt::format("/proc/self/fd/{}", file_.number()); }

 private:
  system::FileDescriptor file_;
};

/// Returns a configuration with the shipped fonts and no others: an installed font of the same name
/// may have another version.
///
/// The files stay open: Cairo caches faces by path, and would confuse them if the number of a
/// closed descriptor were reused.
FontConfig shippedFonts() {
  static const FontFile regular{interRegularFont()};
  static const FontFile semibold{interSemiBoldFont()};
  FontConfig config(FcConfigCreate());
  for (const FontFile* file : {&regular, &semibold}) {
    const std::string path = file->path();
    const auto* name = reinterpret_cast<const FcChar8*>(path.c_str());
    if (!FcConfigAppFontAddFile(config.get(), name)) {
      throw MachineError("fontconfig can't read the font that ships with the program");
    }
  }
  return config;
}

Context contextOf(PangoFontMap* map) {
  Context context(pango_font_map_create_context(map));
  const FontOptions options(cairo_font_options_create());
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  pango_cairo_context_set_font_options(context.get(), options.get());
  pango_cairo_context_set_resolution(context.get(), 72);
  pango_context_set_round_glyph_positions(context.get(), FALSE);
  return context;
}

bool has(PangoFontMap* map, const std::string& family) {
  PangoFontFamily** families = nullptr;
  int count = 0;
  pango_font_map_list_families(map, &families, &count);
  bool found = false;
  for (int i = 0; i < count; ++i) {
    found =
        found || g_ascii_strcasecmp(pango_font_family_get_name(families[i]), family.c_str()) == 0;
  }
  g_free(families);
  return found;
}

Description descriptionOf(const std::string& family, const TextStyle& style) {
  Description description(pango_font_description_new());
  pango_font_description_set_family(description.get(), family.c_str());
  pango_font_description_set_weight(description.get(),
                                    style.bold ? PANGO_WEIGHT_SEMIBOLD : PANGO_WEIGHT_NORMAL);
  pango_font_description_set_absolute_size(description.get(), style.size * PANGO_SCALE);
  return description;
}

LayoutPointer layoutOf(PangoContext* context, const std::string& family, const std::string& text,
                       const TextStyle& style, int width) {
  LayoutPointer layout(pango_layout_new(context));
  pango_layout_set_font_description(layout.get(), descriptionOf(family, style).get());
  pango_layout_set_width(layout.get(), width * PANGO_SCALE);
  pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
  pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
  if (style.tabular) {
    const Attributes attributes(pango_attr_list_new());
    pango_attr_list_insert(attributes.get(), pango_attr_font_features_new("tnum=1"));
    pango_layout_set_attributes(layout.get(), attributes.get());
  }
  return layout;
}

/// Returns the box of the text within its layout, whose lines begin at the right in scripts that
/// are read from there.
PangoRectangle extentsOf(PangoLayout* layout) {
  PangoRectangle box;
  pango_layout_get_pixel_extents(layout, nullptr, &box);
  return box;
}

/// Returns the first letter that the layout's font lacks; there must be one.
std::string unknownLetter(PangoLayout* layout) {
  const char* text = pango_layout_get_text(layout);
  const LayoutIterator iterator(pango_layout_get_iter(layout));
  do {
    const PangoLayoutRun* run = pango_layout_iter_get_run_readonly(iterator.get());
    if (run == nullptr) continue;  // The end of a line.
    for (int i = 0; i < run->glyphs->num_glyphs; ++i) {
      if ((run->glyphs->glyphs[i].glyph & PANGO_GLYPH_UNKNOWN_FLAG) == 0) continue;
      const char* letter = text + run->item->offset + run->glyphs->log_clusters[i];
      return {letter, static_cast<std::size_t>(g_utf8_next_char(letter) - letter)};
    }
  } while (pango_layout_iter_next_run(iterator.get()));
  return text;
}

/// Lays out the text. Throws InputError if the font lacks a letter.
LayoutPointer wholeLayoutOf(PangoContext* context, const std::string& family,
                            const std::string& text, const TextStyle& style, int width) {
  LayoutPointer layout = layoutOf(context, family, text, style, width);
  if (pango_layout_get_unknown_glyphs_count(layout.get()) == 0) return layout;
  throw InputError(
      fmt::format("the font {} lacks \"{}\", which is in \"{}\"; choose an installed font that has "
                  "it, overlay.font = \"...\"",
                  family, unknownLetter(layout.get()), text));
}

void paint(cairo_t* cairo, PangoLayout* layout, const TextStyle& style, const Ink& ink) {
  if (style.halo > 0) {
    pango_cairo_layout_path(cairo, layout);
    const Colour edge = ink(kDark);
    cairo_set_source_rgba(cairo, edge.red, edge.green, edge.blue,
                          kLetterHaloOpacity * style.opacity);
    cairo_set_line_width(cairo, 2 * style.halo);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(cairo);
    cairo_move_to(cairo, 0, 0);
  }
  const Colour colour = ink(style.colour);
  cairo_set_source_rgba(cairo, colour.red, colour.green, colour.blue, style.opacity);
  pango_cairo_show_layout(cairo, layout);
}

}  // namespace

std::string clockText(double time, const scene::Words& words) {
  return words.number(fmt::format("{:.2f} s", time));
}

struct Typesetter::Parts {
  /// Takes the installed fonts if `fonts` is empty.
  Parts(std::string name, FontConfig fonts)
      : config(std::move(fonts)),
        map(pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT)),
        family(std::move(name)) {
    if (config) pango_fc_font_map_set_config(PANGO_FC_FONT_MAP(map.get()), config.get());
    context = contextOf(map.get());
  }

  FontConfig config;
  FontMap map;
  Context context;
  std::string family;
};

const Typesetter::Parts& Typesetter::parts() const {
  if (!parts_) parts_ = std::make_unique<Parts>(kShippedFamily, shippedFonts());
  return *parts_;
}

Typesetter::Typesetter() = default;

Typesetter::Typesetter(const std::string& family)
    : parts_(std::make_unique<Parts>(family, nullptr)) {
  if (has(parts_->map.get(), family)) return;
  throw InputError(
      fmt::format("no font family \"{}\" is installed, which overlay.font names; fc-list : family "
                  "lists those that are",
                  family));
}

Typesetter Typesetter::of(const scene::Scene& scene, const Ink& ink) {
  const std::string& font = scene.overlay.font;
  Typesetter type = font == scene::kBuiltin ? Typesetter()
                                            : scene::atLocationOf(scene, "overlay.font",
                                                                  [&] { return Typesetter(font); });
  type.ink_ = ink;
  return type;
}

Typesetter::Typesetter(Typesetter&&) noexcept = default;
Typesetter::~Typesetter() = default;

TextSize Typesetter::measure(const std::string& text, const TextStyle& style, int width) const {
  const PangoRectangle box =
      extentsOf(layoutOf(parts().context.get(), parts().family, text, style, width).get());
  return {box.width, box.height};
}

bool Typesetter::isReadFromTheRight(const std::string& text) const {
  const LayoutPointer layout = layoutOf(parts().context.get(), parts().family, text, {}, 0);
  return pango_layout_get_direction(layout.get(), 0) == PANGO_DIRECTION_RTL;
}

Layer Typesetter::draw(const std::string& text, const TextStyle& style, int width) const {
  const LayoutPointer layout =
      wholeLayoutOf(parts().context.get(), parts().family, text, style, width);
  const PangoRectangle box = extentsOf(layout.get());
  const int margin = static_cast<int>(std::ceil(style.halo));
  Layer layer{-margin, -margin, box.width + 2 * margin, box.height + 2 * margin, {}};
  layer.pixels.resize(static_cast<std::size_t>(layer.width) *
                      static_cast<std::size_t>(layer.height) * 4);
  const Surface surface(cairo_image_surface_create_for_data(
      layer.pixels.data(), CAIRO_FORMAT_ARGB32, layer.width, layer.height, layer.width * 4));
  const Cairo cairo(cairo_create(surface.get()));
  cairo_translate(cairo.get(), margin - box.x, margin - box.y);
  paint(cairo.get(), layout.get(), style, ink_);
  cairo_surface_flush(surface.get());
  return layer;
}

void Typesetter::draw(const std::string& text, const TextStyle& style, int width, _cairo* cairo,
                      const Point& position) const {
  const LayoutPointer layout =
      wholeLayoutOf(parts().context.get(), parts().family, text, style, width);
  const PangoRectangle box = extentsOf(layout.get());
  cairo_save(cairo);
  cairo_translate(cairo, position.x() - box.x, position.y() - box.y);
  cairo_move_to(cairo, 0, 0);
  paint(cairo, layout.get(), style, ink_);
  cairo_new_path(cairo);
  cairo_restore(cairo);
}

}  // namespace rotatebook::overlay
