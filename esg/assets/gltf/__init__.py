"""glTF files: surfaces as they hold them, reading their parts, writing them."""
