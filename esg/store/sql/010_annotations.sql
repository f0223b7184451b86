-- Texts of scenes, and what other engines and other values make of them (docs/dataset/*.md).
CREATE TABLE captions (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    short VARCHAR,
    medium VARCHAR,
    long VARCHAR,
    event_ids VARCHAR[],
    event_texts VARCHAR[],
    event_times_s DOUBLE[],
    hit_a VARCHAR[], -- every first hit of two bodies, expected or not
    hit_b VARCHAR[],
    hit_times_s DOUBLE[],
    hit_impulses_ns DOUBLE[],
    statements VARCHAR[] -- the prompt's words that the replay keeps
);

CREATE TABLE questions (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    question_index INTEGER NOT NULL,
    kind VARCHAR, -- order, count, cause, speed, direction, what_if
    question VARCHAR,
    answer VARCHAR,
    choices VARCHAR[],
    value DOUBLE,
    unit VARCHAR,
    measure VARCHAR,
    arguments VARCHAR[],
    measured_by VARCHAR
);

CREATE TABLE engine_events (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    engine VARCHAR NOT NULL,
    dt_s DOUBLE NOT NULL,
    event_id VARCHAR NOT NULL, -- empty: the whole scene
    event_index INTEGER,
    event_type VARCHAR,
    completed BOOLEAN, -- null: this replay failed, `reason` says how
    time_s DOUBLE,
    agrees BOOLEAN, -- all engines at all steps say the same
    reason VARCHAR
);

CREATE TABLE what_ifs (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    variable VARCHAR NOT NULL, -- none: the unchanged scene, the base of every pair
    engine VARCHAR NOT NULL,
    pair VARCHAR,
    amount VARCHAR,
    body VARCHAR, -- empty: the whole scene
    value_before DOUBLE,
    value DOUBLE,
    unit VARCHAR,
    dt_s DOUBLE,
    duration_s DOUBLE,
    outcome VARCHAR, -- unchanged, same_events, other_events, not_applicable, diverged, failed, no_base
    reason VARCHAR,
    event_ids VARCHAR[],
    completed BOOLEAN[],
    event_times_s DOUBLE[],
    bodies VARCHAR[],
    final_position_m FLOAT[],
    apart_m DOUBLE, -- from the base, in the same engine
    engines_apart_m DOUBLE,
    agrees BOOLEAN -- all engines see the same events
);

-- Null where the dataset was made without --engines.
ALTER TABLE scenes ADD COLUMN engines_agree BOOLEAN;

-- How often engines agree on events, by type; and on what-ifs, by variable.
CREATE VIEW engine_agreement AS
SELECT
    suite, event_type, count(DISTINCT scene_key || '/' || event_id) AS events,
    count(DISTINCT scene_key || '/' || event_id) FILTER (agrees) AS agreed,
    max(latest - earliest) FILTER (agrees) AS times_apart_max_s,
    avg(latest - earliest) FILTER (agrees) AS times_apart_mean_s
FROM (
    SELECT
        *,
        max(time_s) OVER (PARTITION BY scene_key, event_id) AS latest,
        min(time_s) OVER (PARTITION BY scene_key, event_id) AS earliest
    FROM engine_events
    WHERE event_id <> ''
)
GROUP BY suite, event_type
ORDER BY suite, event_type;

CREATE VIEW what_if_agreement AS
SELECT
    variable,
    amount,
    count(DISTINCT scene_key) AS scenes,
    count(DISTINCT scene_key) FILTER (agrees) AS agreed,
    100.0 * count(DISTINCT scene_key) FILTER (agrees)
        / nullif(count(DISTINCT scene_key) FILTER (agrees IS NOT NULL), 0) AS agreed_percent,
    count(DISTINCT scene_key) FILTER (outcome = 'other_events') AS changed
FROM what_ifs
WHERE outcome <> 'not_applicable'
GROUP BY variable, amount
ORDER BY variable, amount;
