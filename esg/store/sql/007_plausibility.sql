-- What replays show that nature does not: every check with its measured value and limit.
CREATE TABLE plausibility_checks (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    strategy VARCHAR,
    engine VARCHAR NOT NULL,
    check_name VARCHAR NOT NULL,
    check_index INTEGER,
    unit VARCHAR,
    ok BOOLEAN,
    measured DOUBLE, -- the worst against its limit; null: nothing was there to measure
    limit_value DOUBLE,
    body VARCHAR,
    time_s DOUBLE,
    note VARCHAR
);

-- Null for scenes that came to no replay or were recorded before there was plausibility.
ALTER TABLE scenes ADD COLUMN plausible BOOLEAN;

-- Plausibility by suite and check: how many scene runs fail it, and the worst of them.
CREATE VIEW plausibility AS
SELECT
    s.suite, s.strategy, s.engine, c.check_name,
    any_value(c.unit) AS unit,
    count(*) AS scenes,
    count(*) FILTER (NOT c.ok) AS failed,
    100.0 * count(*) FILTER (NOT c.ok) / count(*) AS failed_percent,
    max(c.measured / nullif(c.limit_value, 0)) AS worst_ratio,
    arg_max(c.measured, c.measured / nullif(c.limit_value, 0)) AS worst_measured,
    arg_max(c.limit_value, c.measured / nullif(c.limit_value, 0)) AS worst_limit,
    arg_max(s.scene_id, c.measured / greatest(c.limit_value, 1e-9)) AS worst_scene,
    arg_max(c.body, c.measured / greatest(c.limit_value, 1e-9)) AS worst_body
FROM plausibility_checks AS c
JOIN scenes AS s ON s.scene_key = c.scene_key
GROUP BY s.suite, s.strategy, s.engine, c.check_name
ORDER BY s.suite, s.strategy, s.engine, min(c.check_index);
