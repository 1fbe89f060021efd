// SPDX-License-Identifier: GPL-3.0-or-later
//
// The help of the program and of each command, as a newcomer reads it. A test asks that every option is in here.
#pragma once

namespace delref::program {

inline constexpr const char* program_help = R"(delref: triangle and tetrahedral meshes by Delaunay refinement, with a verdict you can trust

Usage: delref COMMAND ...

Commands
  mesh      mesh a planar domain (a coast, a map, a part with holes), a solid one (a machine part,
            rooms that share walls, a closed surface), or what a function, an image or points on
            a surface describe
  verify    check a mesh again, from scratch, against its input and what was asked for
  info      show the size, the quality and the labels of a mesh

Options
  -h, --help     this text; `delref COMMAND --help` explains a command
  --version      the version

A first run in the plane
  delref mesh coast.poly -o coast.svg -o coast.vtu
  delref verify coast.poly coast.vtu
  delref info coast.vtu

A first run in space
  delref mesh part.off -o part.vtu
  delref verify part.off part.vtu
  delref info part.vtu

A first run with a function (inside is where it is below 0), and one with an image
  delref mesh --implicit 'x^2+y^2+z^2-1' --bounds -2 -2 -2 2 2 2 -o ball.vtu
  delref mesh head.nii.gz --iso 80 -o head.vtu -o head.stl

Exit codes
  0  every criterion is met, or unmet only where small angles of the input force it
  1  an output cannot be written, or an internal error
  2  the command line cannot be understood
  3  the input cannot be read or meshed; the message says which element, where and why
  4  a criterion is unmet for another reason, a part of a smooth surface is missing, or a budget
     was reached (a valid mesh is written)
  5  interrupted (a valid mesh is written)
  6  verification failed
)";

inline constexpr const char* mesh_help = R"(delref mesh: mesh the domain that a file or a function describes

Usage: delref mesh IN -o OUT [-o OUT ...] [options]
       delref mesh --implicit EXPR --bounds X0 Y0 Z0 X1 Y1 Z1 -o OUT [-o OUT ...] [options]

The input says whether triangles fill a domain of the plane or tetrahedra one of space. Options are
for all kinds of input, or for those under whose heading they stand.

  IN             in the plane: .poly or .node of Triangle, .geojson (polygons)
                 solids:       .poly or .smesh of TetGen (facets, regions, holes), and closed
                               surfaces: .off, .obj, .ply, .stl
                 smooth:       images .inr, .nii, .hdr with .img, also with .gz; .nrrd, .nhdr,
                               .mha, .mhd; sets of points .xyz, and .ply with --point-set
  -o, --output OUT
                 the mesh, in the format of the name; give it again for another format
                   .vtu   ParaView, VTK         .msh   gmsh 4.1
                   .node  of the plane: Triangle's .node, .ele, .edge and .poly of that name
                          of space: TetGen's .node, .ele, .face and .edge
                   .mesh  MEDIT
                   .svg   a picture, for a browser; in space, what is seen of it cut open
                 of the plane, and the surfaces of smooth domains:
                   .off   viewers of surfaces
                 of smooth domains only, their surfaces:
                   .stl   3D printers           .ply, .obj   modelling programs

In the plane: triangles
  --min-angle D          no angle below D degrees, 0 <= D < 60 (default 20.7, which is proven to be
                         reached; 30 nearly always is, 33 mostly with --encroachment lens; 0: none)
  --max-area A           no triangle larger than A; regions of the input may have their own bounds
  --max-edge L           no edge longer than L
  --encroachment circle|lens
                         circle (default): every edge is Delaunay. lens: constrained Delaunay, with
                         fewer triangles
  --points off-centre|circumcentre
                         where new vertices go; off-centre (default) needs fewer of them
  --keep-boundary        do not split the segments that bound the domain; triangles that suffer are
                         listed as unmet
  --split-crossings      cut segments that cross or overlap at each other, instead of refusing them
  --svg-colour angle|region
                         what the colours of an .svg tell (default angle)

In space: tetrahedra
  --radius-edge B        no circumradius over B times the shortest edge of its tetrahedron, B >= 1
                         (default 2; proven to be reached in smooth domains; in solids experience
                         says so where input elements meet at 90 degrees or more, and that 1.4
                         nearly always is; 0.61 is the regular tetrahedron)
  --cell-size S          no circumradius greater than S

Solids: facets as they are given
  --max-volume V         no tetrahedron larger than V; regions of the input may have bounds of their
                         own
  --join-coplanar ANGLE  make one facet of neighbours whose planes differ by at most ANGLE degrees
                         (0 to 45; such as 0.01), so that a box of twelve triangles has six facets
  --planarity-tolerance T
                         how far a vertex may be off the plane of its facet, in parts of the facet's
                         diameter (default 1e-5)

Smooth domains: where they come from, one of these
  --implicit EXPR        where EXPR in x, y and z is below 0, such as 'x^2+y^2+z^2-1'. It may have
                         + - * / ^, comparisons, && ||, if(c,a,b), min, max, abs, sqrt, sin, exp
                         and the like. Given again, there are several regions: inside the first
                         function alone is region 1, the second alone 2, both 3, the third 4 ...
  --bounds X0 Y0 Z0 X1 Y1 Z1
                         with --implicit: the box in which the function is looked at, the lower
                         corner first. A domain that reaches it ends there
  --iso V                IN is an image with grey levels: inside is where it is at least V
  --inside above|below   with --iso: at least V (default) or at most V
  --closed               with --iso: what is inside at the border of the image ends there, instead
                         of being refused
  --labels               IN is an image with labels: every label is a region
  --background L|none    with --labels: the label of the outside (default 0)
  --smooth-labels S      with --labels: smooth the staircase over S voxels, 0.3 to 3 (1 is good;
                         single voxels are lost)
  --point-set            a .ply holds points on a surface, with or without normals (an .xyz does)
  --sampling L           with --implicit: look for pieces of the surface down to this size
                         (default: a 64th of the longest side of the bounds)
  --neighbours N         points: their normals, where they have none, are estimated from the N
                         nearest ones (default 18; more where they are noisy)
  --outliers F           points: leave out those further from others than F times what is usual
  --smooth-points N      points: move them N times to where their neighbours suggest (for noise)

Smooth domains: triangles on the surface (lengths in the unit of the input)
  --facet-angle D        no angle below D degrees (default 30, which is proven to be reached)
  --facet-size S         no surface ball (through the corners, centred on the surface) of a radius
                         over S. Default, unless --facet-distance is given: a 20th of the extent of
                         the surface; in images one and a half voxels where that is less (but no
                         less than a 100th); for points, what suits their distances
  --facet-distance D     no facet further than D from the surface
  --surface-only         no tetrahedra
  --region-cell-size LABEL=SIZE
                         --cell-size of one region; may be given again
  --smallest-facet R     leave alone what has a surface ball of a radius of R or less, as at creases
                         (default: a thousandth of the facet size)

In all: sizes from place to place (lengths in the unit of the input)
  --size-points FILE     sizes at points: edges of triangles are no longer, and circumradii of
                         tetrahedra and surface balls no greater, than the size at their place. FILE
                         has lines `x y size` or `x y z size`, and `#` begins a comment
  --gradation G          how much the size grows per unit of distance from these points (default
                         0.3; 0.2 is gentle, 1 abrupt)

In the plane and solids: dirty input
  --merge-tolerance T    make one of vertices no farther apart than T (default 0: equal ones only)

In all: how much it may cost (the mesh reached so far is written. It is valid; but of solids, when
some facets could not be brought into it yet, that is told, and when all is missing none is written)
  --max-vertices N       stop at N vertices (default 20,000,000)
  --time-limit S         end within S seconds, writing included (default 3600)
  --smallest-edge L      leave alone what has an edge no longer than L (default 0)
  Ctrl-C                 stops in the same way; a second time, at once: what is not yet
                         complete is not written

In all: what is told
  --report FILE          everything about the run, as JSON; `delref verify` can read it
  --regions              print how many elements each region has, and its area or volume
  --strict               exit code 4 even for what only small input angles leave unmet
  --quiet                print only errors and what is unmet
  -h, --help             this text

Examples
  delref mesh coast.poly -o coast.svg
        the smallest good mesh, as a picture
  delref mesh plate.poly -o plate.msh --min-angle 30 --max-edge 0.5 --report plate.json
        angles of at least 30 degrees, edges of at most 0.5, and a report
  delref mesh borders.geojson -o borders.vtu --split-crossings --merge-tolerance 1e-9
        input whose borders cross and do not quite meet
  delref mesh part.off -o part.vtu
        the solid that a closed surface bounds
  delref mesh box.stl -o box.msh --join-coplanar 0.01 --cell-size 0.1
        its flat sides meshed as such, and tetrahedra of about one size
  delref mesh rooms.smesh -o rooms.vtu --radius-edge 1.4 --regions
        rooms that share walls, each with the label and the volume bound that the file gives it
  delref mesh --implicit 'x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+11.8' --bounds -3 -3 -3 3 3 3 -o tangle.vtu
        the inside of a surface; --facet-size 0.1 makes it finer
  delref mesh head.nii.gz --iso 80 --facet-distance 0.5 --cell-size 4 -o head.mesh
        an organ out of an image, in the unit of its voxels
  delref mesh brain.inr.gz --labels --smooth-labels 1 --region-cell-size 3=2 -o brain.vtu --regions
        every label of a segmentation, finer in region 3

Exit codes
  0 every criterion met, or unmet only where small input angles force it; 1 an output cannot be
  written; 2 usage; 3 invalid input; 4 unmet for another reason, or a part of a smooth surface is
  missing, or a budget was reached (mesh written, if there was one); 5 interrupted (the same)
)";

inline constexpr const char* verify_help = R"(delref verify: check a mesh against its input and what was asked for

Everything is checked again from the two files, with exact predicates and none of the mesher's code:
that the triangles or tetrahedra cover the domain once, follow every segment (and facet) of the
input, are Delaunay, carry the labels, and meet each criterion. Bad shapes are excused only where
small input angles force them. Of smooth domains: that the surface is closed, a manifold, complete
and where the function or image has it.

Usage: delref verify IN MESH --report FILE
       delref verify IN MESH [criteria as given to `delref mesh`]
       delref verify MESH ... without IN, for a function: --report FILE, or --implicit and --bounds

  IN             the domain that was meshed, as `delref mesh` reads it
  MESH           the mesh: .vtu, .msh, .node / .ele; of space also .mesh
                 (.off, .svg and the .mesh of a planar mesh do not carry enough)

What was promised
  --report FILE          the report of the run: what was asked for, and what it says is unmet.
                         A mesh that was stopped early is verified with this
or, in all
  --size-points FILE     sizes at points, lines `x y size` or `x y z size`
  --gradation G          how the size grows away from them (default 0.3)
in the plane and of solids
  --merge-tolerance T    vertices no farther apart than T were merged first
in the plane
  --min-angle D          no angle below D degrees (default 20.7; 0: no bound)
  --max-area A           no triangle larger than A
  --max-edge L           no edge longer than L
  --encroachment circle|lens
                         circle (default): every edge must be Delaunay; lens: but for segments
  --keep-boundary        no vertex was inserted on the boundary of the domain
  --split-crossings      the input was split at crossings first
in space
  --radius-edge B        no circumradius over B times the shortest edge (default 2)
  --cell-size S          no circumradius greater than S
of solids
  --max-volume V         no tetrahedron larger than V
  --join-coplanar ANGLE  facets within ANGLE degrees of each other were joined first
  --planarity-tolerance T
                         facets were taken to be flat within T of their diameter (default 1e-5)
of smooth domains, what the domain was
  --implicit EXPR        a function, with
  --bounds X0 Y0 Z0 X1 Y1 Z1
                         its box
  --iso V                an image with grey levels
  --inside above|below   where it is at least V (default), or at most
  --closed               closed at its border
  --labels               an image with labels
  --background L|none    the label of the outside (default 0)
  --smooth-labels S      smoothed over S voxels
  --point-set            a .ply with points
  --sampling L           how far down pieces of the surface were looked for
  --neighbours N         how points were prepared: neighbours for normals,
  --outliers F           what was left out,
  --smooth-points N      and how often they were moved
and what was asked of it
  --facet-angle D        no angle of a facet below D degrees (default 30)
  --facet-size S         no surface ball of a radius over S
  --facet-distance D     no facet further than D from the surface
  --surface-only         there are no tetrahedra
  --region-cell-size LABEL=SIZE
                         no circumradius greater than SIZE in that region
  --smallest-facet R     what has a surface ball of a radius of R or less was left alone

  -h, --help             this text

Examples
  delref mesh coast.poly -o coast.vtu --min-angle 30 --report coast.json
  delref verify coast.poly coast.vtu --report coast.json
  delref verify coast.poly coast.vtu --min-angle 30
  delref verify part.off part.vtu --radius-edge 1.4
  delref verify --implicit 'x^2+y^2+z^2-1' --bounds -2 -2 -2 2 2 2 ball.vtu
  delref verify head.nii.gz head.vtu --report head.json

Exit codes
  0 the mesh is what was promised; 2 usage; 3 a file cannot be read; 5 interrupted;
  6 verification failed; 1 internal error
)";

inline constexpr const char* info_help = R"(delref info: show the size, the quality and the labels of a mesh

Usage: delref info MESH

  MESH           the mesh: .vtu, .msh, .node / .ele; of space also .mesh
  -h, --help     this text

Shows how many vertices and triangles or tetrahedra there are, the range of angles, edge lengths and
areas or volumes, and how the angles are spread; in space also radius-edge ratios and slivers, and
of a surface without tetrahedra its pieces, its Euler characteristic and whether it is closed. Then
how many elements have each region label, and triangles on facets or surfaces and edges each marker.
Angles are in degrees, lengths in the unit of the mesh.

Example
  delref info coast.vtu

Exit codes
  0 done; 2 usage; 3 the file cannot be read; 5 interrupted; 1 internal error
)";

}  // namespace delref::program
