"""``python -m carom`` is ``carom``."""

from carom.cli import main

if __name__ == "__main__":
    main()
