-- Only runs of a suite are compared: one prompt after another is no regression.
CREATE OR REPLACE VIEW bench_history AS
WITH ordered AS (
    SELECT
        *,
        max(ecr_mean) OVER (
            PARTITION BY suite, strategy, engine, runs ORDER BY started_at, run_id
        ) AS best_so_far
    FROM bench_summary
    WHERE started_at IS NOT NULL AND suite <> ''
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
