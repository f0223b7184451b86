-- What bodies look like: the meshes of every scene; their glTF stays in Parquet (docs/dataset/layouts.md).
CREATE TABLE meshes (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    mesh VARCHAR NOT NULL,
    asset VARCHAR,
    buffer VARCHAR,
    bytes BIGINT,
    license VARCHAR,
    attribution VARCHAR
);
