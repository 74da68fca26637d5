// The documentation's pages, as text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rotatebook::house {

/// A block between two lines that begin with ```.
struct CodeBlock {
  std::string language;
  std::vector<std::string> lines;
};

/// The text of a file; throws std::runtime_error if it can't be read.
std::string readText(const std::filesystem::path& path);

std::vector<std::string> linesOf(const std::string& text);

std::vector<CodeBlock> codeBlocksOf(const std::string& page);

/// The lines outside of code blocks, and without what is between backticks.
std::vector<std::string> proseOf(const std::string& page);

/// The texts between backticks outside of code blocks; one that is broken has a space there.
std::vector<std::string> codeSpansOf(const std::string& page);

/// README.md, CONTRIBUTING.md, docs/*.md and assets/README.md, relative to the root and sorted.
std::vector<std::string> documentationPages();

}  // namespace rotatebook::house
