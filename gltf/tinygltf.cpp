// SPDX-License-Identifier: MIT
// The body of tinygltf, a library of one header: compiled here once, without its images.
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
