// SPDX-License-Identifier: MIT
//
// Each archetype of the frame models its concept, and no longer does when it loses any one member.
#include <catch2/catch_test_macros.hpp>

#include <delref/core/level_concepts.hpp>
#include <delref/core/queue/bucket_queue.hpp>
#include <delref/core/queue/fifo_queue.hpp>
#include <delref/core/queue/lifo_queue.hpp>

#include "archetypes.hpp"

namespace {

using namespace archetypes;
using namespace delref;

// -- triangulation
static_assert(explain_triangulation<Line>() && Triangulation<Line> && StoresElement<Line, Interval>);

template <LinePart part>
constexpr bool no_types = !TriangulationTypes<LineWithout<part>> && !Triangulation<LineWithout<part>>;
static_assert(no_types<LinePart::point_type> && no_types<LinePart::is_finite> && no_types<LinePart::vertex_type> &&
              no_types<LinePart::edge_type> && no_types<LinePart::hint_type> && no_types<LinePart::zone_type> &&
              no_types<LinePart::dimension>);

static_assert(!FindsConflictZones<LineWithout<LinePart::conflict_zone>> && !Triangulation<LineWithout<LinePart::conflict_zone>>);

template <LinePart part>
constexpr bool no_insertion = !InsertsIntoZones<LineWithout<part>> && !Triangulation<LineWithout<part>>;
static_assert(no_insertion<LinePart::insert> && no_insertion<LinePart::vanishing>);

template <LinePart part>
constexpr bool no_description = !DescribesVertices<LineWithout<part>> && !Triangulation<LineWithout<part>>;
static_assert(no_description<LinePart::point> && no_description<LinePart::index> && no_description<LinePart::carrier> &&
              no_description<LinePart::provenance> && no_description<LinePart::set_origin> &&
              no_description<LinePart::number_of_vertices> && no_description<LinePart::is_simplex> &&
              no_description<LinePart::barycentre>);

static_assert(!ClearsSlots<LineWithout<LinePart::clear_slots>> && !Triangulation<LineWithout<LinePart::clear_slots>>);

// Without these it is a triangulation still, but its intervals are no elements that it stores.
template <LinePart part>
constexpr bool stores_nothing = Triangulation<LineWithout<part>> && !StoresElement<LineWithout<part>, Interval>;
static_assert(stores_nothing<LinePart::hint_from_element> && stores_nothing<LinePart::vertices> && stores_nothing<LinePart::dies>);

// -- level
static_assert(explain_level<Halves, Line>() && MesherLevel<Halves, Line>);

template <LevelPart part>
using LevelWithout = HalvesWithout<part>;
static_assert(!std::move_constructible<LevelWithout<LevelPart::move>> && !MesherLevel<LevelWithout<LevelPart::move>, Line>);
static_assert(!Scans<LevelWithout<LevelPart::scan_triangulation>, Line> &&
              !MesherLevel<LevelWithout<LevelPart::scan_triangulation>, Line>);

template <LevelPart part>
constexpr bool no_queue = !Queues<LevelWithout<part>, Line> && !MesherLevel<LevelWithout<part>, Line>;
static_assert(no_queue<LevelPart::element_type> && no_queue<LevelPart::empty> && no_queue<LevelPart::next_element> &&
              no_queue<LevelPart::pop_next_element>);

static_assert(!Proposes<LevelWithout<LevelPart::refinement_point>, Line> &&
              !MesherLevel<LevelWithout<LevelPart::refinement_point>, Line>);
static_assert(!Checks<LevelWithout<LevelPart::check_refinement_point>, Line> &&
              !MesherLevel<LevelWithout<LevelPart::check_refinement_point>, Line>);

template <LevelPart part>
constexpr bool does_not_follow = !Follows<LevelWithout<part>, Line> && !MesherLevel<LevelWithout<part>, Line>;
static_assert(does_not_follow<LevelPart::before_insertion> && does_not_follow<LevelPart::after_insertion>);

// -- observer
template <Event event>
constexpr bool watches = Observer<Watches<event>, Line>;
static_assert(watches<Event::scanned> && watches<Event::proposed> && watches<Event::rejected> && watches<Event::rejected_forever> &&
              watches<Event::before_insertion> && watches<Event::after_insertion> &&
              watches<Event::progress>);
static_assert(!watches<Event::none>);

// -- queue
static_assert(explain_queue<Stack, Interval>() && RefinementQueue<Stack, Interval>);
static_assert(RefinementQueue<LifoQueue<Interval>, Interval> && RefinementQueue<FifoQueue<Interval>, Interval> &&
              RefinementQueue<BucketQueue<Interval>, Interval>);

template <QueuePart part>
constexpr bool no_policy = !RefinementQueue<StackWithout<part>, Interval>;
static_assert(no_policy<QueuePart::make> && no_policy<QueuePart::move> && no_policy<QueuePart::push> && no_policy<QueuePart::front> &&
              no_policy<QueuePart::at> && no_policy<QueuePart::erase> && no_policy<QueuePart::empty> && no_policy<QueuePart::size> &&
              no_policy<QueuePart::clear> && no_policy<QueuePart::for_each>);

TEST_CASE("the archetypes of the frame model their concepts, and without any one member they do not") {
  SUCCEED("checked by the compiler");
}

}  // namespace
