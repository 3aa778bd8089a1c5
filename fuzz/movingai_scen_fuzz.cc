// MovingAI problems.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_answer.h"
#include "tautline/scene/movingai_scen.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tautline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto problems = ParseMovingAiScen(text, "m.scen");
  fuzz::CheckAnswer(problems);
  if (!problems) return 0;
  for (const ScenProblem& problem : *problems) {
    TAUTLINE_CHECK(std::isfinite(problem.octile_length) && problem.octile_length >= 0);
    TAUTLINE_CHECK(problem.start.column < problem.width && problem.goal.row < problem.height);
  }
  return 0;
}
