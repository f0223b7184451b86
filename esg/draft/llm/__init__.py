"""The llm drafter: any OpenAI-compatible model, asked stage by stage (docs/drafting_llm.md)."""
