#pragma once

#include "core/mesh/mesh.h"
#include "geolloyd/shapes.h"
