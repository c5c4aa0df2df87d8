#pragma once

#include "models/architecture.h"
