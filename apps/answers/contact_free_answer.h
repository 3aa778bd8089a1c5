// The question of `plan --contact-free`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_CONTACT_FREE_ANSWER_H_
#define APPS_ANSWERS_CONTACT_FREE_ANSWER_H_

#include "apps/answers/exit_status.h"
#include "apps/answers/json_values.h"
#include "tautline/base/error.h"
#include "tautline/planners/contact_free/plan_contact_free.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct ContactFreeAnswer {  // NOLINT(bugprone-exception-escape): the JSON library moves its values without noexcept.
  ContactFreeResult result;
  Json json;                        ///< The result as docs/contact_free.md describes it.
  ExitStatus status = kExitSolved;  ///< kExitInfeasible too where the budget ran out.
};

/// Plans. Errors: as PlanContactFree.
[[nodiscard]] Expected<ContactFreeAnswer> AnswerContactFree(const Scene& scene, const ContactFreeOptions& options);

}  // namespace tautline

#endif  // APPS_ANSWERS_CONTACT_FREE_ANSWER_H_
