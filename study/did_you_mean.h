// The name that someone probably meant: of captures, too, so that it lives in motion/.
#pragma once

#include "motion/did_you_mean.h"
