// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of a verification, as they are made one after the other: each leaves a finding, and those that cannot be made leave word
// why not.
#pragma once

#include <delref/mesh/verify/report.hpp>

namespace delref::verification {

/// Enters findings into a report, which must outlive the list.
class CheckList {
 public:
  explicit CheckList(VerifyReport& report) : report_(&report) {}

  /// Makes one check; whether it passed.
  template <class Check>
  bool check(const char* name, Check&& make) {
    report_->findings.push_back({});
    Finding& finding = report_->findings.back();
    finding.name = name;
    finding.status = CheckStatus::passed;
    make(finding);
    return finding.status == CheckStatus::passed;
  }
  /// Makes a check when it is asked for, or else writes down why not.
  template <class Check>
  void check_if(bool wanted, const char* name, const char* why_not, Check&& make) {
    if (wanted) check(name, make);
    else skip(name, why_not);
  }
  void skip(const char* name, const char* why) {
    report_->findings.push_back({});
    report_->findings.back().name = name;
    report_->findings.back().note = why;
  }
  /// The same for all of `names` that are not in the report.
  template <class Names>
  void skip_rest(const Names& names, const char* why) {
    for (const char* name : names)
      if (!report_->find(name)) skip(name, why);
  }

 private:
  VerifyReport* report_;
};

}  // namespace delref::verification
