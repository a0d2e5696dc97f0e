"""The page of the studio: served from the installed package, linked to, and as a player of one recorded run.

What is built of `web/` lies in this folder; it is no part of the repository, and an installation may be without it.
"""

from carom.studio.built import MissingPageError
from carom.studio.link import fragment_of
from carom.studio.player import Player, player_of

__all__ = ["MissingPageError", "Player", "fragment_of", "player_of"]
