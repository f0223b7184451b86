"""The place around the action: which one, what stands in it, and its meshes.

Nothing here is a body. `dress` fills one field of the document, `Dressing`, from the finished
document and its replay; `esg.view.surroundings` draws it (docs/layout/dressing.md).
"""
