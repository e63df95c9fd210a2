#include "studies/commands/commands.hpp"

int main(int argc, char** argv) {
  return studies::main(argc, argv);
}
