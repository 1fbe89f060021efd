// SPDX-License-Identifier: MIT
//
// Observers: user code that watches a run. An observer has any of the members below, and at least one; it is called after the
// levels and sees what they see.
#pragma once

#include <cstddef>
#include <span>

#include <delref/core/carrier.hpp>
#include <delref/core/proposal.hpp>
#include <delref/core/verdict.hpp>

namespace delref {

template <class O, class Tr>
concept ObservesScan = requires(O& o, const Tr& tr) { o.on_scanned(tr); };
template <class O, class Tr>
concept ObservesProposal = requires(O& o, const Tr& tr, const Proposal<Tr>& p) { o.on_proposed(tr, p); };
template <class O, class Tr>
concept ObservesRejection =
    requires(O& o, const Tr& tr, const Proposal<Tr>& p, LevelIndex by) { o.on_rejected(tr, p, by); };
template <class O, class Tr>
concept ObservesRejectionForever =
    requires(O& o, const Tr& tr, const Proposal<Tr>& p, Reason why) { o.on_rejected_forever(tr, p, why); };
template <class O, class Tr>
concept ObservesBeforeInsertion = requires(O& o, const Tr& tr, const Proposal<Tr>& p) { o.on_before_insertion(tr, p); };
template <class O, class Tr>
concept ObservesAfterInsertion =
    requires(O& o, const Tr& tr, typename Tr::Vertex v, const Proposal<Tr>& p) { o.on_after_insertion(tr, v, p); };
/// `queued[i]` elements wait in the set of level i. Sent by `Mesher::refine` every few hundred steps.
template <class O, class Tr>
concept ObservesProgress = requires(O& o, const Tr& tr, std::span<const std::size_t> queued) { o.on_progress(tr, queued); };

/// Watches at least one event of a run on `Tr`.
template <class O, class Tr>
concept Observer = ObservesScan<O, Tr> || ObservesProposal<O, Tr> || ObservesRejection<O, Tr> ||
                   ObservesRejectionForever<O, Tr> || ObservesBeforeInsertion<O, Tr> || ObservesAfterInsertion<O, Tr> ||
                   ObservesProgress<O, Tr>;

/// Fails to compile with a sentence when `O` watches nothing.
template <class O, class Tr>
consteval bool explain_observer() {
  static_assert(Observer<O, Tr>,
                "an observer needs at least one of: on_scanned(tr), on_proposed(tr, proposal), on_rejected(tr, proposal, level), "
                "on_rejected_forever(tr, proposal, reason), on_before_insertion(tr, proposal), "
                "on_after_insertion(tr, vertex, proposal), on_progress(tr, queued)");
  return Observer<O, Tr>;
}

/// The events of a run, sent to those observers of a pack that watch them. The fan-out is a fold: no observer, no code.
namespace notify {
template <class Tr, class... O>
void scanned(const Tr& tr, O&... observers) {
  ([&] { if constexpr (ObservesScan<O, Tr>) observers.on_scanned(tr); }(), ...);
}
template <class Tr, class... O>
void proposed(const Tr& tr, const Proposal<Tr>& p, O&... observers) {
  ([&] { if constexpr (ObservesProposal<O, Tr>) observers.on_proposed(tr, p); }(), ...);
}
template <class Tr, class... O>
void rejected(const Tr& tr, const Proposal<Tr>& p, [[maybe_unused]] LevelIndex by, O&... observers) {
  ([&] { if constexpr (ObservesRejection<O, Tr>) observers.on_rejected(tr, p, by); }(), ...);
}
template <class Tr, class... O>
void rejected_forever(const Tr& tr, const Proposal<Tr>& p, [[maybe_unused]] Reason why, O&... observers) {
  ([&] { if constexpr (ObservesRejectionForever<O, Tr>) observers.on_rejected_forever(tr, p, why); }(), ...);
}
template <class Tr, class... O>
void before_insertion(const Tr& tr, const Proposal<Tr>& p, O&... observers) {
  ([&] { if constexpr (ObservesBeforeInsertion<O, Tr>) observers.on_before_insertion(tr, p); }(), ...);
}
template <class Tr, class... O>
void after_insertion(const Tr& tr, [[maybe_unused]] typename Tr::Vertex v, const Proposal<Tr>& p, O&... observers) {
  ([&] { if constexpr (ObservesAfterInsertion<O, Tr>) observers.on_after_insertion(tr, v, p); }(), ...);
}
template <class Tr, class... O>
void progress(const Tr& tr, std::span<const std::size_t> queued, O&... observers) {
  ([&] { if constexpr (ObservesProgress<O, Tr>) observers.on_progress(tr, queued); }(), ...);
}
}  // namespace notify

}  // namespace delref
