-- What prompts and suites state beyond events, and whether replays keep it (docs/store.md).
CREATE TABLE statements (
    run_id VARCHAR NOT NULL,
    scene_key VARCHAR NOT NULL,
    suite VARCHAR,
    scene_id VARCHAR,
    seed BIGINT,
    strategy VARCHAR,
    engine VARCHAR NOT NULL, -- empty: never judged
    source VARCHAR NOT NULL, -- prompt: the scene's own; suite: what a suite asks for
    statement_id VARCHAR NOT NULL,
    statement_index INTEGER,
    says VARCHAR,
    words VARCHAR,
    start INTEGER,
    stop INTEGER,
    status VARCHAR, -- kept, broken, not_represented, not_judged
    kept BOOLEAN,
    measured VARCHAR,
    reason VARCHAR
);

-- Null for scenes recorded before there were statements.
ALTER TABLE scenes ADD COLUMN fully_understood BOOLEAN;
ALTER TABLE scenes ADD COLUMN statements_kept DOUBLE;

-- Words of prompts that scenes do not show, most frequent first: statements that are broken or not
-- represented, and verbs of which no event was made.
CREATE VIEW not_kept AS
WITH lost AS (
    SELECT scene_key, words, says, status, reason
    FROM statements
    WHERE source = 'prompt' AND status IN ('broken', 'not_represented')
    UNION ALL
    SELECT scene_key, "text", 'event', status, note
    FROM coverage AS c
    WHERE kind = 'event' AND status = 'not_understood'
        AND NOT EXISTS (
            FROM statements AS t
            WHERE t.scene_key = c.scene_key AND t.source = 'prompt'
                AND t.status IN ('broken', 'not_represented')
                AND t.start <= c.start AND c.stop <= t.stop
        )
)
SELECT
    lower(l.words) AS words,
    l.status,
    mode(l.says) AS says,
    count(*) AS occurrences,
    count(DISTINCT l.scene_key) AS scenes,
    mode(nullif(l.reason, '')) AS usual_reason,
    min(s.prompt) AS example_prompt
FROM lost AS l
JOIN scenes AS s ON s.scene_key = l.scene_key
GROUP BY lower(l.words), l.status
ORDER BY occurrences DESC, words, l.status;

-- Statements kept (SKR) by type of scene and of statement.
CREATE VIEW statement_rates AS
SELECT
    s.suite, s.level, s.rule, s.strategy, s.engine, t.source, t.says,
    count(*) AS statements,
    count(*) FILTER (t.status = 'kept') AS kept,
    count(*) FILTER (t.status = 'broken') AS broken,
    count(*) FILTER (t.status = 'not_represented') AS not_represented,
    count(*) FILTER (t.status = 'not_judged') AS not_judged,
    100.0 * count(*) FILTER (t.status = 'kept') / count(*) AS skr
FROM statements AS t
JOIN scenes AS s ON s.scene_key = t.scene_key
GROUP BY ALL
ORDER BY s.suite, s.level, s.rule, s.strategy, s.engine, t.source, t.says;

-- The same rows with the scenes that do not show all of their prompt.
CREATE OR REPLACE VIEW scene_outcomes AS
SELECT
    suite, scene_id, strategy, engine,
    count(*) AS runs,
    count(*) FILTER (outcome = 'solved') AS solved,
    count(*) FILTER (outcome = 'partial') AS "partial",
    count(*) FILTER (outcome = 'nearest_feasible') AS nearest_feasible,
    count(*) FILTER (outcome = 'infeasible') AS infeasible,
    count(*) FILTER (outcome = 'not_converged') AS not_converged,
    count(*) FILTER (outcome = 'invalid_draft') AS invalid_draft,
    count(*) FILTER (outcome = 'crashed') AS crashed,
    avg(verified::INTEGER) AS verified_rate,
    avg(fully_understood::INTEGER) AS understood_rate,
    avg(statements_kept) AS statements_kept,
    avg(n_completed) AS completed_mean,
    max(n_events) AS n_events,
    avg(slr::INTEGER) AS slr_rate,
    avg(ppa) AS ppa,
    avg(seconds) AS seconds,
    mode(nullif(reason, '')) AS usual_reason
FROM scenes
GROUP BY ALL
ORDER BY suite, scene_id, strategy, engine;
