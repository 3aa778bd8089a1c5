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
  bool verified = false;            ///< The motion was driven again.
};

/// Plans; `verify`: and drives the motion again. Errors: as PlanContactFree. Throws std::logic_error where the answer
/// fails verification.
[[nodiscard]] Expected<ContactFreeAnswer> AnswerContactFree(const Scene& scene, const ContactFreeOptions& options,
                                                            bool verify = false);

}  // namespace tautline

#endif  // APPS_ANSWERS_CONTACT_FREE_ANSWER_H_
