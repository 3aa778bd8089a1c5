#include "tautline/planners/contact_free/contact_free_search.h"
