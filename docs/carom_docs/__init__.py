"""What makes Carom's pages: their code blocks, the parts that are generated, the pictures, the links."""
