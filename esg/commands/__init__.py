"""The commands of `esg`, one file each; heavy imports only inside the functions."""

COMMANDS: dict[str, tuple[str, str]] = {
    "draft": ("esg.commands.draft:draft", "Draft the scene graph of a prompt (stage 1 only)."),
    "generate": ("esg.commands.generate:generate", "Generate and prove one scene from a prompt."),
    "up": ("esg.commands.up:up", "Keep a warm worker that makes single scenes at once."),
    "cost": ("esg.commands.cost:cost", "Predict what a dataset costs from measured runs."),
    "bench": ("esg.commands.bench:bench", "Run a benchmark suite over several seeds."),
    "dataset": (
        "esg.commands.datasets.dataset:dataset",
        "Make a dataset of proven scenes, from prompts or sampled.",
    ),
    "serve": ("esg.commands.serve:serve", "Run suites every night and compare with history."),
    "report": ("esg.commands.report:report", "Write one page about a run that opens from disk."),
    "render": ("esg.commands.render:render", "Render ground-truth pictures of a finished scene."),
    "study": (
        "esg.commands.comparing.study:study",
        "Ask people what they see, and analyse the answers.",
    ),
    "view": ("esg.commands.view:view", "Show the player of one scene in the browser."),
    "studio": ("esg.commands.studio:studio", "Write, solve and play scenes on a page."),
    "sql": ("esg.commands.sql:sql", "Query the results of all runs with SQL."),
    "db": ("esg.commands.db:app", "Rebuild, fill, prune and look after the run database."),
    "replay": ("esg.commands.replay:replay", "Replay a finished scene in an engine of choice."),
    "judge": ("esg.commands.comparing.judge:judge", "Judge anybody's trajectories by a suite."),
    "export": ("esg.commands.export:export", "Write a scene for another program."),
    "check": ("esg.commands.check:check", "Check an ESG file against the schema and all rules."),
    "assets": (
        "esg.commands.assets:app",
        "List, search, show and import assets; list materials.",
    ),
    "doctor": (
        "esg.commands.doctor:doctor",
        "Tell what works on this machine and what is missing.",
    ),
    "setup": ("esg.commands.setup:setup", "Compile and cache all kernels, once per machine."),
}
"""Command name to its function ("module:function", imported when called) and its line of help."""
