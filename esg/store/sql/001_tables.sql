-- Tables of the results database: the Parquet tables without trajectories' arrays and documents'
-- duplicates. Keys are those of the Parquet tables; `esg.store.db.ingest` keeps them unique. They are
-- not declared: an index on a million text keys makes an upsert ten times slower.

CREATE TABLE runs (
    run_id VARCHAR NOT NULL,
    kind VARCHAR,
    suite VARCHAR,
    started_at TIMESTAMP, -- UTC
    strategy VARCHAR,
    engine VARCHAR,
    dt_s DOUBLE,
    seeds INTEGER,
    version VARCHAR,
    code_version VARCHAR,
    machine VARCHAR
);

CREATE TABLE scenes (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    level VARCHAR,
    prompt VARCHAR,
    family VARCHAR,
    split VARCHAR,
    drafter VARCHAR,
    strategy VARCHAR,
    engine VARCHAR,
    device VARCHAR,
    dt_s DOUBLE,
    proof VARCHAR,
    outcome VARCHAR,
    reason VARCHAR,
    verified BOOLEAN,
    slr BOOLEAN,
    max_penetration_m DOUBLE,
    n_events INTEGER,
    n_completed INTEGER,
    ppa DOUBLE,
    ppa_strict DOUBLE,
    ppa_lenient DOUBLE,
    seconds DOUBLE,
    cached_stages INTEGER,
    esg_draft VARCHAR,
    esg_resolve VARCHAR,
    esg_layout VARCHAR,
    esg_optimize VARCHAR,
    esg_sha256 VARCHAR,
    artifacts VARCHAR
);

-- Where the arrays are: read them from `file` with read_parquet, pyarrow or datasets.
CREATE TABLE trajectories (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    split VARCHAR,
    engine VARCHAR NOT NULL,
    dt_s DOUBLE,
    fps DOUBLE,
    n_frames INTEGER,
    bodies VARCHAR[],
    file VARCHAR
);

CREATE TABLE metrics (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    strategy VARCHAR,
    engine VARCHAR NOT NULL,
    dt_s DOUBLE,
    event_id VARCHAR NOT NULL,
    event_index INTEGER,
    event_type VARCHAR,
    completed BOOLEAN,
    time_s DOUBLE,
    bodies VARCHAR[],
    reason VARCHAR,
    measured VARCHAR
);

CREATE TABLE constraints (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    strategy VARCHAR,
    engine VARCHAR NOT NULL,
    constraint_index INTEGER NOT NULL,
    "constraint" VARCHAR,
    kind VARCHAR,
    quantity VARCHAR,
    unit VARCHAR,
    target_low DOUBLE,
    target_high DOUBLE,
    measured DOUBLE,
    error DOUBLE,
    score DOUBLE,
    score_strict DOUBLE,
    score_lenient DOUBLE,
    reason VARCHAR
);

CREATE TABLE coverage (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    item_index INTEGER NOT NULL,
    text VARCHAR,
    start INTEGER,
    stop INTEGER,
    kind VARCHAR,
    status VARCHAR,
    pointer VARCHAR,
    note VARCHAR
);

CREATE TABLE timings (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    stage VARCHAR NOT NULL,
    stage_index INTEGER,
    seconds DOUBLE,
    cached BOOLEAN,
    outcome VARCHAR
);

-- One row a Parquet file that has been ingested: an unchanged file is not read again.
CREATE TABLE ingested (
    file VARCHAR PRIMARY KEY,
    table_name VARCHAR,
    size BIGINT,
    modified_ns BIGINT
);
