// SPDX-License-Identifier: MIT
//
// The module delref.core: the frame, without CGAL. This is the list of its public API; the headers say what each name is.
module;

#include <delref/core/budget.hpp>
#include <delref/core/carrier.hpp>
#include <delref/core/level_concepts.hpp>
#include <delref/core/level_options.hpp>
#include <delref/core/mesher.hpp>
#include <delref/core/observer.hpp>
#include <delref/core/outcome.hpp>
#include <delref/core/point.hpp>
#include <delref/core/proposal.hpp>
#include <delref/core/queue/bucket_queue.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/core/queue/fifo_queue.hpp>
#include <delref/core/queue/lifo_queue.hpp>
#include <delref/core/queue/refinement_queue.hpp>
#include <delref/core/triangulation_concept.hpp>
#include <delref/core/verdict.hpp>
#include <delref/testing/laws.hpp>

export module delref.core;

export namespace delref {

// core/point.hpp
using delref::Point2;
using delref::Point3;
using delref::rounding_near;
using delref::Vector2;
using delref::Vector3;

// core/carrier.hpp
using delref::Carrier;
using delref::input_level;
using delref::LevelIndex;

// core/verdict.hpp
using delref::Reason;
using delref::to_string;
using delref::Verdict;

// core/budget.hpp
using delref::Budget;
using delref::Control;
using delref::Interrupted;
using delref::Stop;
using delref::StopCheck;
using delref::throw_if_stopped;

// core/outcome.hpp
using delref::LevelCounts;
using delref::Outcome;
using delref::Unmet;

// core/proposal.hpp
using delref::Location;
using delref::Proposal;

// core/triangulation_concept.hpp
using delref::ClearsSlots;
using delref::DescribesVertices;
using delref::explain_triangulation;
using delref::FindsConflictZones;
using delref::InsertsIntoZones;
using delref::StoresElement;
using delref::Triangulation;
using delref::TriangulationTypes;

// core/level_concepts.hpp
using delref::Checks;
using delref::explain_level;
using delref::explain_optional_members;
using delref::Follows;
using delref::MesherLevel;
using delref::Proposes;
using delref::Queues;
using delref::Scans;

// core/observer.hpp
using delref::explain_observer;
using delref::Observer;
using delref::ObservesAfterInsertion;
using delref::ObservesBeforeInsertion;
using delref::ObservesProgress;
using delref::ObservesProposal;
using delref::ObservesRejection;
using delref::ObservesRejectionForever;
using delref::ObservesScan;

// core/mesher.hpp
using delref::Mesher;
using delref::Step;

// core/queue
using delref::BucketQueue;
using delref::ElementSet;
using delref::explain_queue;
using delref::FifoQueue;
using delref::LifoQueue;
using delref::ListOrder;
using delref::ListQueue;
using delref::QueuePosition;
using delref::RefinementQueue;

}  // namespace delref

// testing/laws.hpp
export namespace delref::testing {
using delref::testing::check_laws;
using delref::testing::LawOptions;
}  // namespace delref::testing
