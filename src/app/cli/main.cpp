#include "cli/program.h"

int main(int argc, char** argv) {
  return rotatebook::cli::runProgram(argc, argv);
}
