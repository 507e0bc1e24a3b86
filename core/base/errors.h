#pragma once

#include "geolloyd/errors.h"
