#pragma once

/// Geodesic centroidal Voronoi tessellations of triangle meshes, and remeshes from them.
///
///   const geolloyd::Mesh scan = geolloyd::read("scan.ply").mesh;
///   const geolloyd::Remesh remesh = geolloyd::remesh(scan, {.vertex_count = 2048});
///   geolloyd::write("remesh.ply", remesh.mesh);
///
/// Results speak the ids of the input (types.h). They are the same to the bit on every machine and
/// any number of threads. What a user can put right is thrown as geolloyd::Error, with one line
/// that says what, where and what to do; nothing is printed, and no function exits. Functions have
/// no state: several threads may call them at once, each with a runtime of its own, as by default.
///
/// Targets: geolloyd::parallel (all threads, and this header); geolloyd::core alone (the sequential
/// reference: pass reference_runtime()). geolloyd::evaluation (evaluation.h) and geolloyd::render
/// (render.h) have headers of their own.

#include "geolloyd/choices.h"     // enumerations, progress
#include "geolloyd/dual.h"        // dual: the mesh of a tessellation
#include "geolloyd/errors.h"      // Error, InvalidInput, IoError
#include "geolloyd/fields.h"      // curvature_field, cross_field
#include "geolloyd/mesh.h"        // Mesh, read, write
#include "geolloyd/properties.h"  // Properties: colours, normals, labels
#include "geolloyd/quality.h"     // quality and topology of a mesh
#include "geolloyd/relax.h"       // relax, voronoi, distances
#include "geolloyd/remesh.h"      // remesh: the surface remesh
#include "geolloyd/repair.h"      // repair
#include "geolloyd/runtime.h"     // Runtime: who computes
#include "geolloyd/shapes.h"      // generated meshes
#include "geolloyd/threads.h"     // Threads
#include "geolloyd/types.h"       // ids, Vec3
