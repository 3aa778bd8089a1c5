// The pictures of learning, the same for every face.
#ifndef APPS_PICTURES_LEARN_PICTURES_H_
#define APPS_PICTURES_LEARN_PICTURES_H_

#include <memory>
#include <string>
#include <vector>

#include "apps/answers/learn_answer.h"

namespace tautline {

/// As SVG: the path of a policy, the reference, the cable now and then, what touched what.
std::string DrawAnswer(const Scene& scene, const LearnAnswer& answer);

/// The drive as a film; where it could not begin, a picture that stands still.
std::string AnimateAnswer(const Scene& scene, const LearnAnswer& answer);

/// As SVG: the return of episodes and of greedy ones over the steps, with the band between the seeds. Requires a run.
std::string DrawCurves(const std::vector<std::unique_ptr<TrainingRun>>& runs);

/// As SVG: where the robot was while it learned, over all runs. Requires a run.
std::string DrawVisits(const Scene& scene, const LearnSetup& setup,
                       const std::vector<std::unique_ptr<TrainingRun>>& runs);

}  // namespace tautline

#endif  // APPS_PICTURES_LEARN_PICTURES_H_
