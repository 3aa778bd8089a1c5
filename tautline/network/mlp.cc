#include "tautline/network/mlp.h"
