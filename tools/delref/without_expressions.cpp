// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/domain/invalid_input.hpp>

#include "smooth_domain.hpp"

namespace delref::program {

SmoothDomain function_domain(const ReportedSmoothOptions&, const Control&, std::vector<std::string>&) {
  throw InvalidInput("--implicit: this delref was built without muParser, which reads expressions; build it where muParser is installed");
}

}  // namespace delref::program
