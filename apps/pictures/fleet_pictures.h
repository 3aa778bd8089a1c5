// The pictures of answers about fleets, the same for every face.
#ifndef APPS_PICTURES_FLEET_PICTURES_H_
#define APPS_PICTURES_FLEET_PICTURES_H_

#include <string>

#include "apps/answers/check_answer.h"
#include "apps/answers/fleet_plan_answer.h"
#include "apps/answers/layouts_answer.h"
#include "apps/answers/simulate_answer.h"

namespace tautline {

/// The layout, with what is wrong with it. As SVG, as all of these.
std::string DrawAnswer(const Scene& scene, const CheckAnswer& answer);

/// The shortest layouts side by side.
std::string DrawAnswer(const Scene& scene, const LayoutsAnswer& answer);

/// The plan; or the layout, where there is none.
std::string DrawAnswer(const Scene& scene, const FleetPlanAnswer& answer);

/// The plan as a film; where there is none, a picture that stands still. Requires that the question asked for frames,
/// see FilmFrames.
std::string AnimateAnswer(const Scene& scene, const FleetPlanAnswer& answer);

/// What came of a motion; or the layout, where nothing did.
std::string DrawAnswer(const Scene& scene, const SimulateAnswer& answer);

/// The motion as a film; where robots meet, a picture that stands still. Requires frames, as for plans.
std::string AnimateAnswer(const Scene& scene, const SimulateAnswer& answer);

}  // namespace tautline

#endif  // APPS_PICTURES_FLEET_PICTURES_H_
