-- The same rows, twice as fast over a million metrics: texts are only counted where events failed.
CREATE OR REPLACE VIEW event_timings AS
WITH timed AS (
    SELECT
        suite, scene_id, event_id, event_type, strategy, engine,
        count(*) AS runs,
        count(*) FILTER (completed) AS completed,
        avg(completed::INTEGER) AS completion_rate,
        avg(time_s) FILTER (completed) AS time_mean_s,
        stddev_pop(time_s) FILTER (completed) AS time_std_s,
        min(time_s) FILTER (completed) AS time_min_s,
        max(time_s) FILTER (completed) AS time_max_s
    FROM metrics
    GROUP BY ALL
),
causes AS (
    SELECT suite, scene_id, event_id, event_type, strategy, engine, reason, count(*) AS times
    FROM metrics
    WHERE NOT completed AND reason <> ''
    GROUP BY ALL
),
usual AS (
    SELECT
        suite, scene_id, event_id, event_type, strategy, engine,
        arg_max(reason, {'times': times, 'reason': reason}) AS usual_reason
    FROM causes
    GROUP BY ALL
)
SELECT t.*, u.usual_reason
FROM timed AS t
LEFT JOIN usual AS u
    ON t.suite IS NOT DISTINCT FROM u.suite
    AND t.scene_id IS NOT DISTINCT FROM u.scene_id
    AND t.event_id = u.event_id
    AND t.event_type IS NOT DISTINCT FROM u.event_type
    AND t.strategy IS NOT DISTINCT FROM u.strategy
    AND t.engine = u.engine
ORDER BY t.suite, t.scene_id, t.event_id, t.strategy, t.engine;
