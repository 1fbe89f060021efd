// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/mesh/verify_polyhedral.hpp>

#include "polyhedral_run.hpp"

namespace delref::program {

VerifyReport run_verification(const Plc& input, const TetrahedralMesh& mesh, const PolyhedralCriteria& criteria,
                              const ReportedOptions&, const Control& control) {
  return verify_polyhedral(input, mesh, criteria, control);
}

}  // namespace delref::program
