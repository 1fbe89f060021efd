// SPDX-License-Identifier: GPL-3.0-or-later
//
// The module delref: meshing in the plane and in space, the file formats, and the module delref.core. This is the list of its public API; the headers
// say what each name is. Among it is every type that a level or a criterion of your own is handed: a program that also includes
// CGAL gains nothing by the import.
module;

#include <delref/algorithms/check_polyhedral_options.hpp>
#include <delref/algorithms/excuse_small_angles.hpp>
#include <delref/algorithms/extract_planar_mesh.hpp>
#include <delref/algorithms/extract_tetrahedral_mesh.hpp>
#include <delref/algorithms/planar.hpp>
#include <delref/algorithms/planar_levels.hpp>
#include <delref/algorithms/planar_options.hpp>
#include <delref/algorithms/planar_refinement.hpp>
#include <delref/algorithms/polyhedral.hpp>
#include <delref/algorithms/polyhedral_levels.hpp>
#include <delref/algorithms/polyhedral_options.hpp>
#include <delref/algorithms/polyhedral_refinement.hpp>
#include <delref/criteria/angle_bound.hpp>
#include <delref/criteria/point_sizing.hpp>
#include <delref/criteria/sizing_field.hpp>
#include <delref/criteria/tetrahedron_criteria.hpp>
#include <delref/criteria/tetrahedron_shape.hpp>
#include <delref/criteria/triangle_criteria.hpp>
#include <delref/criteria/triangle_shape.hpp>
#include <delref/domain/build_planar_domain.hpp>
#include <delref/domain/build_polyhedral_domain.hpp>
#include <delref/domain/check_plc.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/label_polyhedral_domain.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/domain/plc.hpp>
#include <delref/domain/plc_options.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/domain/pslg_check.hpp>
#include <delref/domain/pslg_crossings.hpp>
#include <delref/domain/small_angle_guard.hpp>
#include <delref/io/geojson.hpp>
#include <delref/io/medit.hpp>
#include <delref/io/medit_reader.hpp>
#include <delref/io/mesh_formats.hpp>
#include <delref/io/msh.hpp>
#include <delref/io/msh_reader.hpp>
#include <delref/io/obj_reader.hpp>
#include <delref/io/off.hpp>
#include <delref/io/off_reader.hpp>
#include <delref/io/planar_formats.hpp>
#include <delref/io/plc_file.hpp>
#include <delref/io/ply_reader.hpp>
#include <delref/io/polygons.hpp>
#include <delref/io/polyhedral_formats.hpp>
#include <delref/io/report.hpp>
#include <delref/io/report_json.hpp>
#include <delref/io/stl_reader.hpp>
#include <delref/io/svg.hpp>
#include <delref/io/tetgen_mesh.hpp>
#include <delref/io/tetgen_poly.hpp>
#include <delref/io/tetrahedral_formats.hpp>
#include <delref/io/triangle_mesh.hpp>
#include <delref/io/triangle_poly.hpp>
#include <delref/io/vtu.hpp>
#include <delref/io/vtu_reader.hpp>
#include <delref/levels/edges_level_2.hpp>
#include <delref/levels/edges_level_3.hpp>
#include <delref/levels/encroachment.hpp>
#include <delref/levels/faces_level_2.hpp>
#include <delref/levels/facets_level_3.hpp>
#include <delref/levels/point_choice.hpp>
#include <delref/levels/region_repair.hpp>
#include <delref/levels/tetrahedra_level_3.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/quality.hpp>
#include <delref/mesh/quality_table.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/tetrahedral_quality.hpp>
#include <delref/mesh/tetrahedral_quality_table.hpp>
#include <delref/mesh/tetrahedron_measures.hpp>
#include <delref/mesh/triangle_measures.hpp>
#include <delref/mesh/verify_planar.hpp>
#include <delref/mesh/verify_polyhedral.hpp>
#include <delref/triangulation/constrained_delaunay_2.hpp>
#include <delref/triangulation/delaunay_3.hpp>
#include <delref/triangulation/planar_concept.hpp>
#include <delref/triangulation/spatial_concept.hpp>

export module delref;
export import delref.core;

export namespace delref {

// algorithms: the functions that most users call, and the same as objects
using delref::check_polyhedral_options;
using delref::Encroachment;
using delref::mesh_planar;
using delref::mesh_polyhedron;
using delref::PlanarOptions;
using delref::PlanarRefinement;
using delref::PlanarResult;
using delref::PointChoice;
using delref::PolyhedralOptions;
using delref::PolyhedralRefinement;
using delref::PolyhedralResult;

// algorithms: what those are made of
using delref::conforming_levels;
using delref::extract_planar_mesh;
using delref::extract_tetrahedral_mesh;
using delref::insert_input_points;
using delref::planar_levels;
using delref::polyhedral_levels;
using delref::SmallAngleExcuses;

// domain
using delref::all_collinear;
using delref::check_plc;
using delref::check_pslg;
using delref::CheckedPslg;
using delref::Defect;
using delref::describe;
using delref::find_crossings;
using delref::InvalidInput;
using delref::PlanarDomain;
using delref::PlanarDomainBuilder;
using delref::PlaneFrame;
using delref::Plc;
using delref::PlcOptions;
using delref::PolyhedralDomain;
using delref::PolyhedralDomainLabeller;
using delref::PolyhedralRegions;
using delref::Pslg;
using delref::PslgCheckOptions;
using delref::SmallAngleGuard;

// triangulation; its handles, zones and ranges are members
using delref::ConstrainedDelaunay2;
using delref::Delaunay3;
using delref::PlanarTriangulation;
using delref::SpatialTriangulation;

// levels and their policies
using delref::Circumcentre;
using delref::DiametralCircle;
using delref::DiametralLens;
using delref::EdgesLevel2;
using delref::EdgesLevel3;
using delref::EdgesOptions;
using delref::Encroachment2;
using delref::explain_encroachment;
using delref::explain_point_choice;
using delref::FacesLevel2;
using delref::FacetsLevel3;
using delref::OffCentre;
using delref::PointChoice2;
using delref::RegionRepair;
using delref::TetrahedraLevel3;

// criteria
using delref::AngleBound;
using delref::checked_size;
using delref::checked_size_at;
using delref::explain_sizing_field;
using delref::explain_sizing_field_3;
using delref::explain_tetrahedron_criterion;
using delref::explain_triangle_criterion;
using delref::MaximumArea;
using delref::MaximumCircumradius;
using delref::MaximumEdge;
using delref::MaximumRegionArea;
using delref::MaximumRegionVolume;
using delref::MaximumVolume;
using delref::MinimumAngle;
using delref::PointSizing2;
using delref::PointSizing3;
using delref::PointSizing;
using delref::RadiusEdge;
using delref::SizeAtCentroid;
using delref::SizeAtCircumcentre;
using delref::SizingField2;
using delref::SizingField3;
using delref::TetrahedronCriteria;
using delref::TetrahedronCriterion;
using delref::TetrahedronShape;
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
using delref::PolyhedralCriteria;
using delref::quality_table;
using delref::tetrahedral_quality;
using delref::TetrahedralMesh;
using delref::TetrahedralQuality;
using delref::TetrahedronMeasures;
using delref::TriangleMeasures;
using delref::verify_planar;
using delref::verify_polyhedral;
using delref::verify_table;
using delref::VerifyReport;

// io: domains
using delref::Dimension;
using delref::domain_dimension;
using delref::LabelledPolygon;
using delref::parse_geojson;
using delref::parse_obj;
using delref::parse_off;
using delref::parse_ply;
using delref::parse_stl;
using delref::parse_tetgen_node;
using delref::parse_tetgen_poly;
using delref::parse_triangle_node;
using delref::PlcFile;
using delref::polygons_to_pslg;
using delref::PslgFile;
using delref::read_geojson;
using delref::read_obj;
using delref::read_off;
using delref::read_plc;
using delref::read_ply;
using delref::read_pslg;
using delref::read_stl;
using delref::read_tetgen_node;
using delref::read_tetgen_poly;
using delref::read_triangle_node;
using delref::read_triangle_poly;
using delref::TetgenFile;

// io: meshes
using delref::AnyMesh;
using delref::check_planar_output;
using delref::check_tetrahedral_output;
using delref::OutputError;
using delref::parse_medit;
using delref::parse_msh;
using delref::parse_tetgen_mesh;
using delref::parse_triangle_mesh;
using delref::parse_vtu;
using delref::planar_mesh_files;
using delref::PlanarFileContext;
using delref::read_medit;
using delref::read_mesh;
using delref::read_msh;
using delref::read_planar_mesh;
using delref::read_tetgen_mesh;
using delref::read_tetrahedral_mesh;
using delref::read_triangle_mesh;
using delref::read_vtu;
using delref::SvgColouring;
using delref::SvgOptions;
using delref::tetgen_mesh_files;
using delref::TetgenMeshText;
using delref::tetrahedral_mesh_files;
using delref::TetrahedralFileContext;
using delref::triangle_mesh_files;
using delref::TriangleMeshText;
using delref::write_medit;
using delref::write_msh;
using delref::write_off;
using delref::write_planar_mesh;
using delref::write_svg;
using delref::write_tetgen_mesh;
using delref::write_tetrahedral_mesh;
using delref::CutSvgOptions;
using delref::write_cut_svg;
using delref::write_triangle_mesh;
using delref::write_vtu;

// io: reports
using delref::BasicPromise;
using delref::BasicRunReport;
using delref::parse_report;
using delref::PolyhedralPromise;
using delref::PolyhedralRunReport;
using delref::read_report;
using delref::report_text;
using delref::ReportedAngle;
using delref::ReportedCounts;
using delref::ReportedOptions;
using delref::ReportedPromise;
using delref::RunReport;
using delref::write_report;

}  // namespace delref
