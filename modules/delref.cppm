// SPDX-License-Identifier: GPL-3.0-or-later
//
// The module delref: planar meshing, the file formats, and the module delref.core. This is the list of its public API; the headers
// say what each name is. Among it is every type that a level or a criterion of your own is handed: a program that also includes
// CGAL gains nothing by the import.
module;

#include <delref/algorithms/excuse_small_angles.hpp>
#include <delref/algorithms/extract_planar_mesh.hpp>
#include <delref/algorithms/planar.hpp>
#include <delref/algorithms/planar_levels.hpp>
#include <delref/algorithms/planar_options.hpp>
#include <delref/algorithms/planar_refinement.hpp>
#include <delref/criteria/angle_bound.hpp>
#include <delref/criteria/point_sizing.hpp>
#include <delref/criteria/sizing_field.hpp>
#include <delref/criteria/triangle_criteria.hpp>
#include <delref/criteria/triangle_shape.hpp>
#include <delref/domain/build_planar_domain.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/domain/pslg_check.hpp>
#include <delref/domain/pslg_crossings.hpp>
#include <delref/io/geojson.hpp>
#include <delref/io/medit.hpp>
#include <delref/io/msh.hpp>
#include <delref/io/msh_reader.hpp>
#include <delref/io/off.hpp>
#include <delref/io/planar_formats.hpp>
#include <delref/io/polygons.hpp>
#include <delref/io/report.hpp>
#include <delref/io/report_json.hpp>
#include <delref/io/svg.hpp>
#include <delref/io/triangle_mesh.hpp>
#include <delref/io/triangle_poly.hpp>
#include <delref/io/vtu.hpp>
#include <delref/io/vtu_reader.hpp>
#include <delref/levels/edges_level_2.hpp>
#include <delref/levels/encroachment.hpp>
#include <delref/levels/faces_level_2.hpp>
#include <delref/levels/point_choice.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/quality.hpp>
#include <delref/mesh/quality_table.hpp>
#include <delref/mesh/triangle_measures.hpp>
#include <delref/mesh/verify_planar.hpp>
#include <delref/triangulation/constrained_delaunay_2.hpp>
#include <delref/triangulation/planar_concept.hpp>

export module delref;
export import delref.core;

export namespace delref {

// algorithms: the function that most users call, and the same as an object
using delref::Encroachment;
using delref::mesh_planar;
using delref::PlanarOptions;
using delref::PlanarRefinement;
using delref::PlanarResult;
using delref::PointChoice;

// algorithms: what those are made of
using delref::extract_planar_mesh;
using delref::planar_levels;
using delref::SmallAngleExcuses;

// domain
using delref::all_collinear;
using delref::check_pslg;
using delref::CheckedPslg;
using delref::Defect;
using delref::describe;
using delref::find_crossings;
using delref::InvalidInput;
using delref::PlanarDomain;
using delref::PlanarDomainBuilder;
using delref::Pslg;
using delref::PslgCheckOptions;

// triangulation; its handles, zones and ranges are members
using delref::ConstrainedDelaunay2;
using delref::PlanarTriangulation;

// levels and their policies
using delref::Circumcentre;
using delref::DiametralCircle;
using delref::DiametralLens;
using delref::EdgesLevel2;
using delref::EdgesOptions;
using delref::Encroachment2;
using delref::FacesLevel2;
using delref::OffCentre;
using delref::PointChoice2;

// criteria
using delref::AngleBound;
using delref::checked_size;
using delref::explain_sizing_field;
using delref::explain_triangle_criterion;
using delref::MaximumArea;
using delref::MaximumEdge;
using delref::MaximumRegionArea;
using delref::MinimumAngle;
using delref::PointSizing2;
using delref::SizeAtCentroid;
using delref::SizingField2;
using delref::TriangleCriteria;
using delref::TriangleCriterion;
using delref::TriangleShape;

// mesh: the result, its quality, its verification
using delref::angle_degrees;
using delref::CheckStatus;
using delref::Finding;
using delref::histogram_text;
using delref::planar_quality;
using delref::PlanarCriteria;
using delref::PlanarMesh;
using delref::PlanarQuality;
using delref::quality_table;
using delref::TriangleMeasures;
using delref::verify_planar;
using delref::verify_table;
using delref::VerifyReport;

// io: domains
using delref::LabelledPolygon;
using delref::parse_geojson;
using delref::parse_triangle_node;
using delref::polygons_to_pslg;
using delref::PslgFile;
using delref::read_geojson;
using delref::read_pslg;
using delref::read_triangle_node;
using delref::read_triangle_poly;

// io: meshes
using delref::check_planar_output;
using delref::OutputError;
using delref::parse_msh;
using delref::parse_triangle_mesh;
using delref::parse_vtu;
using delref::planar_mesh_files;
using delref::PlanarFileContext;
using delref::read_msh;
using delref::read_planar_mesh;
using delref::read_triangle_mesh;
using delref::read_vtu;
using delref::SvgColouring;
using delref::SvgOptions;
using delref::TriangleMeshText;
using delref::write_medit;
using delref::write_msh;
using delref::write_off;
using delref::write_planar_mesh;
using delref::write_svg;
using delref::write_triangle_mesh;
using delref::write_vtu;

// io: reports
using delref::parse_report;
using delref::read_report;
using delref::report_text;
using delref::ReportedCounts;
using delref::ReportedOptions;
using delref::ReportedPromise;
using delref::RunReport;
using delref::write_report;

}  // namespace delref
