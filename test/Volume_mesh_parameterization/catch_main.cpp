#define CATCH_CONFIG_RUNNER // for Catch2 version 2
#include "catch.h"

int main(int argc, char* argv[])
{
  return Catch::Session().run(argc, argv);
}
