// SPDX-License-Identifier: GPL-3.0-or-later
//
// The help of the program and of each command, as a newcomer reads it. A test asks that every option is in here.
#pragma once

namespace delref::program {

inline constexpr const char* program_help = R"(delref: triangle meshes by Delaunay refinement, with a verdict you can trust

Usage: delref COMMAND ...

Commands
  mesh      mesh a planar domain: a coast, a map, a part with holes
  verify    check a mesh again, from scratch, against its input and what was asked for
  info      show the size, the quality and the labels of a mesh

Options
  -h, --help     this text; `delref COMMAND --help` explains a command
  --version      the version

A first run
  delref mesh coast.poly -o coast.svg -o coast.vtu
  delref verify coast.poly coast.vtu
  delref info coast.vtu

Exit codes
  0  every criterion is met, or unmet only where small angles of the input force it
  1  an output cannot be written, or an internal error
  2  the command line cannot be understood
  3  the input cannot be read or meshed; the message says which element, where and why
  4  a criterion is unmet for another reason, or a budget was reached (a valid mesh is written)
  5  interrupted (a valid mesh is written)
  6  verification failed
)";

inline constexpr const char* mesh_help = R"(delref mesh: mesh the domain that a file describes

Usage: delref mesh IN -o OUT [-o OUT ...] [options]

  IN             the domain: .poly or .node of Triangle, .geojson (polygons)
  -o, --output OUT
                 the mesh, in the format of the name; give it again for another format
                   .vtu   ParaView, VTK         .msh   gmsh 4.1
                   .node  Triangle: .node, .ele, .edge and .poly of that name
                   .mesh  MEDIT                 .off   viewers of surfaces
                   .svg   a picture, for a browser

Shape of the triangles
  --min-angle D          no angle below D degrees, 0 <= D < 60 (default 20.7, which is proven to be
                         reached; 30 nearly always is, 33 mostly with --encroachment lens; 0: none)

Size of the triangles (lengths in the unit of the input, areas in its square)
  --max-area A           no triangle larger than A; regions of the input may have their own bounds
  --max-edge L           no edge longer than L
  --size-points FILE     edges no longer than the size at their place; FILE has lines `x y size`,
                         and `#` begins a comment
  --gradation G          how much the size grows per unit of distance from these points (default
                         0.3; 0.2 is gentle, 1 abrupt)

How to refine
  --encroachment circle|lens
                         circle (default): every edge is Delaunay. lens: constrained Delaunay, with
                         fewer triangles
  --points off-centre|circumcentre
                         where new vertices go; off-centre (default) needs fewer of them
  --keep-boundary        do not split the segments that bound the domain; triangles that suffer are
                         listed as unmet

Dirty input
  --split-crossings      cut segments that cross or overlap at each other, instead of refusing them
  --merge-tolerance T    make one of vertices no farther apart than T (default 0: equal ones only)

How much it may cost (the mesh reached so far is valid, and written)
  --max-vertices N       stop at N vertices (default 20,000,000)
  --time-limit S         stop after S seconds (default 3600)
  --smallest-edge L      leave alone what has an edge no longer than L (default 0)
  Ctrl-C                 stops in the same way; a second time, at once and without a mesh

What is told
  --report FILE          everything about the run, as JSON; `delref verify` can read it
  --svg-colour angle|region
                         what the colours of an .svg tell (default angle)
  --strict               exit code 4 even for what only small input angles leave unmet
  --quiet                print only errors and what is unmet
  -h, --help             this text

Examples
  delref mesh coast.poly -o coast.svg
        the smallest good mesh, as a picture
  delref mesh part.poly -o part.msh --min-angle 30 --max-edge 0.5 --report part.json
        angles of at least 30 degrees, edges of at most 0.5, and a report
  delref mesh borders.geojson -o borders.vtu --split-crossings --merge-tolerance 1e-9
        input whose borders cross and do not quite meet

Exit codes
  0 every criterion met, or unmet only where small input angles force it; 1 an output cannot be
  written; 2 usage; 3 invalid input; 4 unmet for another reason, or a budget reached (mesh written);
  5 interrupted (mesh written)
)";

inline constexpr const char* verify_help = R"(delref verify: check a mesh against its input and what was asked for

Everything is checked again from the two files, with exact predicates and none of the mesher's code:
that the triangles cover the domain once, follow every segment of the input, are Delaunay, carry the
labels, and meet each criterion. Small angles are excused only where small input angles force them.

Usage: delref verify IN MESH --report FILE
       delref verify IN MESH [criteria as given to `delref mesh`]

  IN             the domain that was meshed: .poly, .node or .geojson
  MESH           the mesh: .vtu, .msh, or .node / .ele (.mesh, .off and .svg do not carry enough)

What was promised
  --report FILE          the report of the run: what was asked for, and what it says is unmet.
                         A mesh that was stopped early is verified with this
or
  --min-angle D          no angle below D degrees (default 20.7; 0: no bound)
  --max-area A           no triangle larger than A
  --max-edge L           no edge longer than L
  --size-points FILE     sizes at points, lines `x y size`
  --gradation G          how the size grows away from them (default 0.3)
  --encroachment circle|lens
                         circle (default): every edge must be Delaunay; lens: but for segments
  --keep-boundary        no vertex was inserted on the boundary of the domain
  --split-crossings      the input was split at crossings first
  --merge-tolerance T    vertices no farther apart than T were merged first

  -h, --help             this text

Examples
  delref mesh coast.poly -o coast.vtu --min-angle 30 --report coast.json
  delref verify coast.poly coast.vtu --report coast.json
  delref verify coast.poly coast.vtu --min-angle 30

Exit codes
  0 the mesh is what was promised; 2 usage; 3 a file cannot be read; 5 interrupted;
  6 verification failed; 1 internal error
)";

inline constexpr const char* info_help = R"(delref info: show the size, the quality and the labels of a mesh

Usage: delref info MESH

  MESH           the mesh: .vtu, .msh, or .node / .ele
  -h, --help     this text

Shows how many vertices and triangles there are, the range of angles, edge lengths and areas, how
the angles are spread, and how many triangles have each region label and edges each marker. Angles
are in degrees, lengths in the unit of the mesh.

Example
  delref info coast.vtu

Exit codes
  0 done; 2 usage; 3 the file cannot be read; 5 interrupted; 1 internal error
)";

}  // namespace delref::program
