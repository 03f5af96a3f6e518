//! Run folders: nothing foreign is overwritten, nothing leaves the folder, files are whole.

use houscaper::run::{FolderError, RunFolder};

#[test]
fn a_new_run_takes_an_absent_or_empty_folder_only() {
    let place = tempfile::tempdir().unwrap();
    let fresh = place.path().join("results/a");
    RunFolder::create(&fresh, b"{}").unwrap();
    assert_eq!(std::fs::read(fresh.join("run.json")).unwrap(), b"{}");
    assert!(matches!(RunFolder::create(&fresh, b"2"), Err(FolderError::RunExists { .. })));
    assert_eq!(std::fs::read(fresh.join("run.json")).unwrap(), b"{}", "the first run stands");

    let foreign = place.path().join("thesis");
    std::fs::create_dir(&foreign).unwrap();
    std::fs::write(foreign.join("chapter.txt"), "precious").unwrap();
    assert!(matches!(RunFolder::create(&foreign, b"{}"), Err(FolderError::NotARun { .. })));
    assert_eq!(std::fs::read_dir(&foreign).unwrap().count(), 1, "nothing was added");
    assert!(matches!(RunFolder::create(&foreign.join("chapter.txt"), b"{}"), Err(FolderError::NotARun { .. })));
    assert!(matches!(RunFolder::open(&foreign), Err(FolderError::NoRun { .. })));
}

#[test]
fn paths_stay_inside() {
    let place = tempfile::tempdir().unwrap();
    let run = RunFolder::create(&place.path().join("run"), b"{}").unwrap();
    for bad in ["../x", "a/../../x", "/etc/x", "", ".", "a//b", "a/./b", "a\\..\\b", "c:x", "a/"] {
        assert!(matches!(run.write(bad, b""), Err(FolderError::Outside { .. })), "{bad:?}");
    }
    run.write("front/12/house.glb", b"glb").unwrap();
    assert_eq!(run.read("front/12/house.glb").unwrap().unwrap(), b"glb");
    assert_eq!(run.read("front/13/house.glb").unwrap(), None);
    assert_eq!(std::fs::read_dir(place.path()).unwrap().count(), 1, "only the run itself");
}

#[test]
fn files_are_replaced_whole_and_leftovers_swept() {
    let place = tempfile::tempdir().unwrap();
    let root = place.path().join("run");
    let run = RunFolder::create(&root, b"{}").unwrap();
    run.write("evaluations.csv", b"id\n1\n2\n").unwrap();
    run.write("evaluations.csv", b"id\n").unwrap();
    assert_eq!(run.read("evaluations.csv").unwrap().unwrap(), b"id\n");
    std::fs::write(root.join(".evaluations.csv.part"), "torn").unwrap();
    let again = RunFolder::open(&root).unwrap();
    assert_eq!(again, run);
    let names: Vec<_> = std::fs::read_dir(&root).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(names.len(), 2, "{names:?}");
    run.write("front/1/a", b"").unwrap();
    run.remove_folder("front/1").unwrap();
    run.remove_folder("front/1").unwrap();
    assert!(!root.join("front/1").exists());
}
