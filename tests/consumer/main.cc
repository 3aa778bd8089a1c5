#include <cstdio>

#include "tautline/base/rng.h"

int main() {
  tautline::Rng rng(1);
  std::printf("%f\n", rng.Uniform());
}
