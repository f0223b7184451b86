-- The usual questions, one view each (docs/sql.md has examples).

-- One row a run, suite and engine: the table of the paper. ECR's std is over per-run (seed) sums.
CREATE VIEW bench_summary AS
WITH per_seed AS (
    SELECT
        run_id, suite, engine, seed,
        sum(n_completed) AS completed,
        sum(n_events) AS events,
        count(*) AS scenes,
        avg(slr::INTEGER) AS slr,
        avg(verified::INTEGER) AS verified,
        sum(seconds) AS seconds
    FROM scenes
    GROUP BY ALL
),
ppa AS (
    SELECT
        run_id, suite, engine,
        100 * avg(score) AS ppa,
        100 * avg(score_strict) AS ppa_strict,
        100 * avg(score_lenient) AS ppa_lenient,
        count(*) AS measurements
    FROM constraints
    GROUP BY ALL
)
SELECT
    s.run_id,
    r.started_at,
    s.suite,
    any_value(r.strategy) AS strategy,
    s.engine,
    any_value(r.dt_s) AS dt_s,
    count(*) AS runs,
    max(s.scenes) AS scenes,
    max(s.events) AS events,
    avg(s.completed) AS ecr_mean,
    stddev_pop(s.completed) AS ecr_std,
    100 * sum(s.slr * s.scenes) / sum(s.scenes) AS slr,
    100 * sum(s.verified * s.scenes) / sum(s.scenes) AS verified,
    any_value(p.ppa) AS ppa,
    any_value(p.ppa_strict) AS ppa_strict,
    any_value(p.ppa_lenient) AS ppa_lenient,
    sum(s.seconds) / sum(s.scenes) AS seconds_per_scene
FROM per_seed AS s
LEFT JOIN runs AS r ON r.run_id = s.run_id
LEFT JOIN ppa AS p ON p.run_id = s.run_id AND p.suite = s.suite AND p.engine = s.engine
GROUP BY s.run_id, r.started_at, s.suite, s.engine
ORDER BY r.started_at DESC, s.run_id, s.suite, s.engine;

-- Nightly trend: every run beside the last good one before it, the latest earlier run of the same
-- suite, strategy, engine and number of seeds that completed as many events as any before it.
CREATE VIEW bench_history AS
WITH ordered AS (
    SELECT
        *,
        max(ecr_mean) OVER (
            PARTITION BY suite, strategy, engine, runs ORDER BY started_at, run_id
        ) AS best_so_far
    FROM bench_summary
    WHERE started_at IS NOT NULL
),
compared AS (
    SELECT
        o.*,
        g.run_id AS last_good,
        g.ecr_mean AS last_good_ecr,
        g.ecr_std AS last_good_ecr_std,
        g.slr AS last_good_slr,
        g.ppa AS last_good_ppa,
        g.seconds_per_scene AS last_good_seconds
    FROM ordered AS o
    LEFT JOIN LATERAL (
        SELECT * FROM ordered AS e
        WHERE e.suite = o.suite AND e.strategy = o.strategy AND e.engine = o.engine
            AND e.runs = o.runs AND e.ecr_mean >= e.best_so_far
            AND (e.started_at, e.run_id) < (o.started_at, o.run_id)
        ORDER BY e.started_at DESC, e.run_id DESC
        LIMIT 1
    ) AS g ON true
)
SELECT
    run_id, started_at, suite, strategy, engine, runs, events, ecr_mean, ecr_std, slr, ppa,
    seconds_per_scene, last_good, last_good_ecr,
    ecr_mean - last_good_ecr AS ecr_change,
    slr - last_good_slr AS slr_change,
    ppa - last_good_ppa AS ppa_change,
    seconds_per_scene / nullif(last_good_seconds, 0) AS time_ratio,
    coalesce(
        ecr_mean < last_good_ecr - greatest(0.5, last_good_ecr_std)
        OR slr < last_good_slr - 5
        OR ppa < last_good_ppa - 5,
        false
    ) AS regressed
FROM compared
ORDER BY suite, strategy, engine, runs, started_at, run_id;

-- How the scenes of a suite end, per strategy and engine.
CREATE VIEW scene_outcomes AS
SELECT
    suite, scene_id, strategy, engine,
    count(*) AS runs,
    count(*) FILTER (outcome = 'solved') AS solved,
    count(*) FILTER (outcome = 'nearest_feasible') AS nearest_feasible,
    count(*) FILTER (outcome = 'infeasible') AS infeasible,
    count(*) FILTER (outcome = 'not_converged') AS not_converged,
    count(*) FILTER (outcome = 'invalid_draft') AS invalid_draft,
    count(*) FILTER (outcome = 'crashed') AS crashed,
    avg(verified::INTEGER) AS verified_rate,
    avg(n_completed) AS completed_mean,
    max(n_events) AS n_events,
    avg(slr::INTEGER) AS slr_rate,
    avg(ppa) AS ppa,
    avg(seconds) AS seconds,
    mode(nullif(reason, '')) AS usual_reason
FROM scenes
GROUP BY ALL
ORDER BY suite, scene_id, strategy, engine;

-- When events happen, how reliably, and what usually keeps them from happening.
CREATE VIEW event_timings AS
SELECT
    suite, scene_id, event_id, event_type, strategy, engine,
    count(*) AS runs,
    count(*) FILTER (completed) AS completed,
    avg(completed::INTEGER) AS completion_rate,
    avg(time_s) FILTER (completed) AS time_mean_s,
    stddev_pop(time_s) FILTER (completed) AS time_std_s,
    min(time_s) FILTER (completed) AS time_min_s,
    max(time_s) FILTER (completed) AS time_max_s,
    mode(nullif(reason, '')) FILTER (NOT completed) AS usual_reason
FROM metrics
GROUP BY ALL
ORDER BY suite, scene_id, event_id, strategy, engine;

-- The paper's table of absolute parameter errors.
CREATE VIEW constraint_errors AS
SELECT
    suite, scene_id, constraint_index, "constraint", kind, quantity, unit, strategy, engine,
    count(*) AS runs,
    count(measured) AS evaluated,
    avg(error) AS error_mean,
    stddev_pop(error) AS error_std,
    max(error) AS error_max,
    avg(score) AS score,
    avg(score_strict) AS score_strict,
    avg(score_lenient) AS score_lenient
FROM constraints
GROUP BY ALL
ORDER BY suite, scene_id, constraint_index, strategy, engine;

-- Whether an event of one scene happens alike in two engines (engine_a < engine_b).
CREATE VIEW engine_transfer AS
SELECT
    a.suite, a.scene_id, a.event_id, a.event_type, a.strategy,
    a.engine AS engine_a,
    b.engine AS engine_b,
    count(*) AS runs,
    avg((a.completed = b.completed)::INTEGER) AS agreement,
    avg(a.completed::INTEGER) AS completed_a,
    avg(b.completed::INTEGER) AS completed_b,
    avg(abs(a.time_s - b.time_s)) FILTER (a.completed AND b.completed) AS time_difference_mean_s,
    max(abs(a.time_s - b.time_s)) FILTER (a.completed AND b.completed) AS time_difference_max_s
FROM metrics AS a
JOIN metrics AS b
    ON a.scene_key = b.scene_key AND a.event_id = b.event_id AND a.engine < b.engine
GROUP BY ALL
ORDER BY a.suite, a.scene_id, a.event_id, engine_a, engine_b;

-- Where the time goes. Cached results cost nothing and are counted apart.
CREATE VIEW cost_per_stage AS
SELECT
    run_id, stage,
    min(stage_index) AS stage_index,
    count(*) AS scenes,
    count(*) FILTER (cached) AS cached,
    sum(seconds) AS seconds,
    avg(seconds) FILTER (NOT cached) AS mean_s,
    quantile_cont(seconds, 0.5) FILTER (NOT cached) AS median_s,
    quantile_cont(seconds, 0.95) FILTER (NOT cached) AS p95_s,
    sum(seconds) / nullif(sum(sum(seconds)) OVER (PARTITION BY run_id), 0) AS share
FROM timings
GROUP BY run_id, stage
ORDER BY run_id, stage_index;

-- What prompts say and scenes lack, most frequent first.
CREATE VIEW coverage_gaps AS
SELECT
    c.kind, c.status,
    lower(c.text) AS text,
    count(*) AS occurrences,
    count(DISTINCT c.scene_key) AS scenes,
    mode(nullif(c.note, '')) AS usual_note,
    min(s.prompt) AS example_prompt
FROM coverage AS c
JOIN scenes AS s ON s.scene_key = c.scene_key
WHERE c.status <> 'used'
GROUP BY ALL
ORDER BY occurrences DESC, c.kind, text;
