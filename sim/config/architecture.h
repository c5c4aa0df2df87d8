#pragma once

#include "models/units/architecture.h"
