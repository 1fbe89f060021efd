// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program used of the machine, for the figures that it prints.
#pragma once

#include <ctime>

#include <sys/resource.h>

namespace benchmark {

/// Seconds of processor time that this program has used: what other work on the machine does to it least.
inline double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The most memory that was resident at any time, in units of 2^20 bytes.
inline double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace benchmark
