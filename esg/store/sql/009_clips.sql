-- What cameras saw of scenes; files, cameras, boxes and tracks stay in Parquet (docs/dataset/clips.md).
CREATE TABLE clips (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    split VARCHAR,
    prompt VARCHAR,
    camera INTEGER NOT NULL,
    camera_kind VARCHAR,
    width INTEGER,
    height INTEGER,
    fps DOUBLE,
    n_frames INTEGER,
    renderer VARCHAR,
    samples INTEGER,
    channels VARCHAR[],
    place VARCHAR, -- that the scene is shown in
    sky VARCHAR
);
