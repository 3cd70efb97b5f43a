// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Excludes instruction sets for which Highway cannot compile the closed form. Include this before Highway's headers.

#if defined(__aarch64__)
// The closed form stores Highway's vectors in structs, which is impossible for vectors of unknown length (SVE).
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#elif defined(_WIN64) && defined(__GNUC__) && !defined(__clang__)
// On 64-bit Windows, GCC aligns the stack to 16 bytes but stores wider vectors there as if they were aligned, which
// crashes. Therefore only SSE is used.
#define HWY_DISABLED_TARGETS (HWY_AVX2 | HWY_AVX3 | HWY_AVX3_DL)
#endif
