// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/invalid_input.hpp>

#include "smooth_domain.hpp"

namespace delref::program {

SmoothDomain image_domain(const std::string& path, const ReportedSmoothOptions&, const Control&, std::vector<std::string>&) {
  throw InvalidInput(path + ": this delref was built without the libraries that read images; build it where zlib and libnifti are installed");
}

}  // namespace delref::program
