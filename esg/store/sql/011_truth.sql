-- Ground truth of clips against geometry: residuals of every check (docs/dataset/truth.md).
CREATE TABLE truth_checks (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    camera INTEGER NOT NULL, -- -1: a check of the replay, not of a clip
    check_name VARCHAR NOT NULL,
    unit VARCHAR,
    samples BIGINT,
    p50 DOUBLE,
    p90 DOUBLE,
    p99 DOUBLE,
    worst DOUBLE,
    limit_value DOUBLE, -- that p99 must not exceed
    ok BOOLEAN,
    note VARCHAR
);

-- The scene of a dataset that this one repeats; null: it repeats none (docs/dataset/variety.md).
ALTER TABLE scenes ADD COLUMN duplicate_of VARCHAR;
