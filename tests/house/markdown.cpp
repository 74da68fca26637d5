#include "house/markdown.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace rotatebook::house {

namespace fs = std::filesystem;

std::string readText(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error("can't read " + path.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<CodeBlock> codeBlocksOf(const std::string& page) {
  std::vector<CodeBlock> blocks;
  bool isInside = false;
  for (const std::string& line : linesOf(page)) {
    if (line.starts_with("```")) {
      isInside = !isInside;
      if (isInside) blocks.push_back({line.substr(3), {}});
    } else if (isInside) {
      blocks.back().lines.push_back(line);
    }
  }
  return blocks;
}

namespace {

std::vector<std::string> linesOutsideOfBlocks(const std::string& page) {
  std::vector<std::string> lines;
  bool isInside = false;
  for (const std::string& line : linesOf(page)) {
    const bool isFence = line.starts_with("```");
    if (isFence) isInside = !isInside;
    if (!isFence && !isInside) lines.push_back(line);
  }
  return lines;
}

}  // namespace

std::vector<std::string> proseOf(const std::string& page) {
  static const std::regex kCode("`[^`]*`");
  std::vector<std::string> prose = linesOutsideOfBlocks(page);
  for (std::string& line : prose) line = std::regex_replace(line, kCode, "");
  return prose;
}

std::vector<std::string> codeSpansOf(const std::string& page) {
  static const std::regex kCode("`([^`]+)`");
  std::string text;
  for (const std::string& line : linesOutsideOfBlocks(page)) text += line + ' ';
  std::vector<std::string> spans;
  for (std::sregex_iterator it(text.begin(), text.end(), kCode), end; it != end; ++it) {
    spans.push_back((*it)[1]);
  }
  return spans;
}

std::vector<std::string> documentationPages() {
  std::vector<std::string> pages{"CONTRIBUTING.md", "README.md", "assets/README.md"};
  const fs::path root = ROTATEBOOK_SOURCE;
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") {
      pages.push_back(entry.path().lexically_relative(root).string());
    }
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

}  // namespace rotatebook::house
