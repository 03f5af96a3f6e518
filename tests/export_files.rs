//! GLB and OBJ: what is written is what other programs read; tables keep their columns.

#[path = "common/houses.rs"]
mod houses;
#[path = "common/khronos.rs"]
mod khronos;

use houscaper::envelope::Surface;
use houscaper::export::tables::{Cell, DesignRow, ExplorerRow, bom_csv, csv, designs_csv, explorer_csv, number};
use houscaper::export::{
    MaterialLook, Part, Scene, SceneError, Showing, bar_solid, beam_solid, flatten, from_envelope, to_glb, to_mtl,
    to_obj,
};
use houscaper::price::BillLine;
use houscaper::quantities::Unit;
use serde_json::{Value, json};

fn villa() -> Scene {
    from_envelope(
        &houses::villa(),
        Showing::default(),
        json!({"id": 12, "price_eur": 128000.5}),
        |s| json!({"surface": s.name()}),
    )
}

/// More vertices than 16 bits can count.
fn large() -> Scene {
    let mut part = Part::new("many", 0);
    for i in 0..3000 {
        let x = f64::from(i) * 0.1;
        part.append(&beam_solid([x, 0.0, 0.0], [x, 1.0, 0.0], [0.0, 0.0, 1.0], 0.05, 0.05));
    }
    Scene { materials: vec![MaterialLook::matt("timber", 0xB08D65, 0.8)], parts: vec![part], ..Scene::default() }
}

/// A bar that sags, in two views.
fn bar() -> Scene {
    let stations: Vec<[f64; 3]> = (0..=4).map(|n| [f64::from(n), 0.0, 2.0]).collect();
    let mut part = bar_solid(&stations, [0.0, 0.0, 1.0], 0.1, 0.2);
    part.name = "joist".into();
    let sag = |x: f64| -0.01 * x * (4.0 - x);
    part.moves = part.vertices.iter().map(|v| [0.0, 0.0, sag(v[0])]).collect();
    part.views = vec![1, 2, 1];
    let looks = [("timber", 0xB08D65), ("compression", 0x2C5F9E), ("tension", 0x9E2A1F)];
    Scene {
        materials: looks.map(|(name, colour)| MaterialLook::matt(name, colour, 0.8)).to_vec(),
        parts: vec![
            part,
            Part { name: "post".into(), ..beam_solid([0.0; 3], [0.0, 0.0, 2.0], [1.0, 0.0, 0.0], 0.1, 0.1) },
        ],
        views: ["axial force", "bending", "again"].map(str::to_owned).to_vec(),
        shape: Some("deformed, 50 times".into()),
        extras: Value::Null,
    }
}

#[test]
fn views_are_variants_of_materials_and_the_deformed_shape_a_morph_target() {
    let scene = bar();
    let glb = to_glb(&scene).unwrap();
    let gltf = gltf::Gltf::from_slice(&glb).unwrap();
    let json = serde_json::to_value(gltf.document.clone().into_json()).unwrap();
    let mesh = &json["meshes"][0];
    assert_eq!(json["extensionsUsed"], json!(["KHR_materials_variants"]));
    // Views that show the same material share a mapping; a part without views keeps its own.
    let mappings = &mesh["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"];
    assert_eq!(*mappings, json!([{"material": 1, "variants": [0, 2]}, {"material": 2, "variants": [1]}]));
    assert!(json["meshes"][1]["primitives"][0].get("extensions").is_none());
    assert_eq!(mesh["extras"]["targetNames"], json!(["deformed, 50 times"]));
    assert_eq!(mesh["weights"], json!([0.0]));
    let blob = gltf.blob.as_deref().unwrap();
    let mut meshes = gltf.meshes();
    let primitive = meshes.next().unwrap().primitives().next().unwrap();
    let reader = primitive.reader(|_| Some(blob));
    let (moves, _, _) = reader.read_morph_targets().next().unwrap();
    let positions = reader.read_positions().unwrap();
    let mut lowest = 0.0f32;
    for (p, m) in positions.zip(moves.unwrap()) {
        let expected = -0.01 * p[0] * (4.0 - p[0]);
        assert!(m[0] == 0.0 && m[2] == 0.0 && (m[1] - expected).abs() < 1e-7, "{p:?} moves {m:?}");
        lowest = lowest.min(m[1]);
    }
    assert_eq!(lowest, -0.04);
    assert_eq!(meshes.next().unwrap().primitives().next().unwrap().morph_targets().count(), 0);
}

/// What is apart is in a scene of its own with what is seen, and in no OBJ and not within the bounds.
#[test]
fn parts_apart_have_a_scene_of_their_own() {
    let mut scene = bar();
    let arrow = beam_solid([0.0, 0.0, 9.0], [0.0, 0.0, 8.0], [1.0, 0.0, 0.0], 0.1, 0.1);
    scene.parts.insert(1, Part { name: "loads: snow".into(), is_apart: true, ..arrow });
    let gltf = gltf::Gltf::from_slice(&to_glb(&scene).unwrap()).unwrap();
    let names = |s: gltf::Scene| s.nodes().map(|n| n.name().unwrap().to_owned()).collect::<Vec<_>>();
    assert_eq!(names(gltf.default_scene().unwrap()), ["joist", "post"]);
    let own = gltf.scenes().nth(1).unwrap();
    assert_eq!(own.name(), Some("loads: snow"));
    // What is seen stands there as one node that shares its arrays.
    assert_eq!(names(own.clone()), ["seen", "loads: snow"]);
    let beside = own.nodes().next().unwrap().mesh().unwrap();
    let positions: Vec<usize> =
        beside.primitives().map(|p| p.get(&gltf::Semantic::Positions).unwrap().index()).collect();
    let shown = gltf.default_scene().unwrap().nodes().map(|n| n.mesh().unwrap().primitives().next().unwrap());
    assert_eq!(positions, shown.map(|p| p.get(&gltf::Semantic::Positions).unwrap().index()).collect::<Vec<_>>());
    assert!(!to_obj(&scene, "a.mtl").unwrap().contains("snow"));
    assert_eq!(scene.bounds(), bar().bounds());
    // A view shows the same parts in its materials.
    let tension = scene.in_view(1);
    assert_eq!((tension.parts[0].material, tension.parts[2].material), (2, 0));
}

#[test]
fn glb_reads_back_as_written() {
    let scene = villa();
    let bytes = to_glb(&scene).unwrap();
    println!(
        "villa.glb: {} bytes, {} triangles",
        bytes.len(),
        scene.parts.iter().map(|p| p.triangles.len()).sum::<usize>()
    );
    assert_eq!(bytes, to_glb(&scene).unwrap(), "equal scenes, equal bytes");
    let gltf = gltf::Gltf::from_slice(&bytes).unwrap();
    let blob = gltf.blob.as_deref().unwrap();
    let root = gltf.default_scene().unwrap();
    let about: Value = serde_json::from_str(root.extras().as_ref().unwrap().get()).unwrap();
    assert_eq!(about["price_eur"], 128000.5);
    // The hip closes to a ridge, so its flat top has no area and is left out.
    let parts: Vec<&Part> = scene.parts.iter().filter(|p| !flatten(p).triangles.is_empty()).collect();
    assert_eq!(parts.len() + 1, scene.parts.len());
    assert_eq!(root.nodes().count(), parts.len());
    let (mut low, mut high) = ([f32::MAX; 3], [f32::MIN; 3]);
    for (node, part) in root.nodes().zip(parts) {
        assert_eq!(node.name(), Some(part.name.as_str()));
        let extras: Value = serde_json::from_str(node.extras().as_ref().unwrap().get()).unwrap();
        assert_eq!(extras, part.extras);
        let primitive = node.mesh().unwrap().primitives().next().unwrap();
        let look = &scene.materials[part.material];
        assert_eq!(primitive.material().name(), Some(look.name.as_str()));
        assert_eq!(primitive.material().pbr_metallic_roughness().base_color_factor()[0], look.rgba[0] as f32);
        let reader = primitive.reader(|_| Some(blob));
        let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
        let flat = flatten(part);
        assert_eq!(positions.len(), flat.positions.len());
        let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
        assert_eq!(indices, flat.triangles.concat());
        for (n, m) in reader.read_normals().unwrap().zip(&flat.normals) {
            assert_eq!(n, [m[0], m[2], 0.0 - m[1]], "normals are turned as positions are");
        }
        let bounds = primitive.bounding_box();
        for (p, a) in positions.iter().flat_map(|p| (0..3).map(move |a| (p, a))) {
            assert!(bounds.min[a] <= p[a] && p[a] <= bounds.max[a]);
            (low[a], high[a]) = (low[a].min(p[a]), high[a].max(p[a]));
        }
    }
    let [l, h] = scene.bounds().unwrap().map(|b| b.map(|c| c as f32));
    assert_eq!((low, high), ([l[0], l[2], -h[1]], [h[0], h[2], -l[1]]), "y is up");
}

#[test]
fn long_indices_and_empty_scenes() {
    let glb = to_glb(&large()).unwrap();
    let gltf = gltf::Gltf::from_slice(&glb).unwrap();
    let primitive = gltf.meshes().next().unwrap().primitives().next().unwrap();
    assert_eq!(primitive.indices().unwrap().data_type(), gltf::accessor::DataType::U32);
    let empty = to_glb(&Scene::default()).unwrap();
    assert_eq!(gltf::Gltf::from_slice(&empty).unwrap().nodes().count(), 0);
}

#[test]
fn broken_scenes_are_refused_with_the_part_named() {
    let mut scene = villa();
    scene.parts[0].triangles.push([0, 1, 999_999]);
    assert!(matches!(scene.check(), Err(SceneError::NoSuchVertex { .. })));
    assert!(to_glb(&scene).unwrap_err().to_string().contains("part 'wall'"));
    let mut scene = villa();
    scene.parts[1].views = vec![99];
    assert!(to_glb(&scene).unwrap_err().to_string().contains("material 99"));
    scene.parts[1] = Part { views: Vec::new(), material: 99, ..scene.parts[1].clone() };
    assert!(to_glb(&scene).unwrap_err().to_string().contains("material 99"));
    let mut scene = villa();
    scene.parts[0].vertices[3][1] = f64::NAN;
    assert!(matches!(to_obj(&scene, "a.mtl"), Err(SceneError::NotFinite { vertex: 3, .. })));
}

#[test]
fn khronos_finds_no_errors_and_no_warnings() {
    let folder = tempfile::tempdir().unwrap();
    let mut loaded = bar();
    let arrow = beam_solid([0.0, 0.0, 9.0], [0.0, 0.0, 8.0], [1.0, 0.0, 0.0], 0.1, 0.1);
    loaded.parts.push(Part { name: "loads: snow".into(), is_apart: true, ..arrow });
    let all = [
        ("villa.glb", villa()),
        ("large.glb", large()),
        ("bar.glb", bar()),
        ("loaded.glb", loaded),
        ("empty.glb", Scene::default()),
    ];
    let files: Vec<_> = all
        .map(|(name, scene)| {
            let path = folder.path().join(name);
            std::fs::write(&path, to_glb(&scene).unwrap()).unwrap();
            path
        })
        .to_vec();
    khronos::validate(&files);
}

#[test]
fn obj_reads_back_with_a_group_a_material() {
    let scene = villa();
    let text = to_obj(&scene, "house.mtl").unwrap();
    assert!(text.contains("unit: metre, up axis: z"));
    let mtl = to_mtl(&scene.materials);
    let (models, materials) =
        tobj::load_obj_buf(&mut text.as_bytes(), &tobj::GPU_LOAD_OPTIONS, |_| tobj::load_mtl_buf(&mut mtl.as_bytes()))
            .unwrap();
    let materials = materials.unwrap();
    for part in &scene.parts {
        let name = &scene.materials[part.material].name;
        let count: usize = models
            .iter()
            .filter(|m| m.mesh.material_id.is_some_and(|i| &materials[i].name == name))
            .map(|m| m.mesh.indices.len() / 3)
            .sum();
        assert_eq!(count, flatten(part).triangles.len(), "{name}");
        assert!(text.contains(&format!("g {name}\n")));
    }
}

#[test]
fn setting_windows_back_keeps_the_envelopes_area_in_view() {
    let flush =
        from_envelope(&houses::villa(), Showing { reveal_m: 0.0, ..Showing::default() }, Value::Null, |_| Value::Null);
    assert!(flush.parts.iter().all(|p| p.name != "frame"));
    let set = villa();
    let window = |s: &Scene| s.parts.iter().find(|p| p.name == Surface::Window.name()).unwrap().triangles.len();
    assert_eq!(window(&flush), window(&set));
    assert!(set.parts.iter().any(|p| p.name == "frame"));
}

#[test]
fn tables_quote_and_keep_columns() {
    assert_eq!(csv(&["a", "b"], [vec![Cell::from("x, \"y\"\n"), 0.1.into()]]), "a,b\n\"x, \"\"y\"\"\n\",0.1\n");
    assert_eq!(
        [number(0.1 + 0.2), number(-0.0), number(f64::NAN), number(1e-9), number(128000.0)],
        ["0.30000000000000004", "0", "", "1e-9", "128000"]
    );
    for v in [1.0 / 3.0, 1e22, 5e-324, -123456.789] {
        assert_eq!(number(v).parse::<f64>().unwrap(), v);
    }
    let row = DesignRow {
        id: 7,
        generation: 2,
        feasible: false,
        violation: 0.5,
        objectives: vec![],
        variables: vec![Cell::Count(3)],
    };
    assert_eq!(
        designs_csv(&["price_eur", "gwp_kgco2e"], &["storeys"], &[row]),
        "id,generation,feasible,violation,price_eur,gwp_kgco2e,storeys\n7,2,false,0.5,,,3\n"
    );
    let bom = bom_csv(&[BillLine {
        line: 1,
        group: "wall".into(),
        item: String::new(),
        description: String::new(),
        quantity: 0.0,
        unit: Unit::SquareMetre,
        rate: 0.0,
        amount: 2.0,
        amount_low: 1.5,
        amount_high: 3.0,
        mass_kg: 0.0,
        gwp_kgco2e: 0.0,
        biogenic_kgco2e: 0.0,
        energy_mj: None,
        source: String::new(),
    }]);
    assert!(bom.starts_with("line,group,item,description,quantity,unit,rate,amount,amount_low,amount_high,mass_kg,gwp_kgco2e,biogenic_kgco2e,energy_mj,source\n1,wall,,,0,m2,0,2,1.5,3,0,0,0,unknown,"));
    let explorer =
        ExplorerRow { id: 4, inputs: vec![Cell::Count(2)], outputs: vec![1.5], image: "front/4/thumb.png".into() };
    assert_eq!(
        explorer_csv(&["storeys"], &["price_eur"], &[explorer]),
        "in:id,in:storeys,out:price_eur,img\n4,2,1.5,front/4/thumb.png\n"
    );
}
