#include "tautline/planners/contact_free/plan_contact_free.h"
