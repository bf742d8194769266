"""Content security policies: what a page may run and load, told to the browser in the page itself."""

import base64
import hashlib
import re
from collections.abc import Iterable

_SCRIPT_INSIDE = re.compile(r"<script(?![^>]*\bsrc=)[^>]*>(.*?)</script>", re.DOTALL)


def policy(scripts: Iterable[str], styles: Iterable[str]) -> str:
    """Return a policy that forbids all but some scripts and styles, by their digests.

    Nothing comes from the network or from files. Drawings carry their colours in attributes.
    """
    return (
        "default-src 'none'; img-src data:; font-src data:; base-uri 'none'; form-action 'none'; "
        f"script-src {_digests(scripts)}; style-src-elem {_digests(styles)}; style-src-attr 'unsafe-inline'"
    )


def with_policy_of_site(page: str) -> str:
    """Return a page of the site with a policy that forbids all but the site's own files.

    It may be opened from a folder, where a page's own place is no origin. The scripts inside the page are its
    own: it was made from this project's files alone.
    """
    own = "'self' file:"
    told = (
        f"default-src 'none'; base-uri 'none'; form-action 'none'; connect-src {own}; "
        f"script-src {own} {_digests(dict.fromkeys(_SCRIPT_INSIDE.findall(page)))}; "
        f"style-src {own} 'unsafe-inline'; img-src {own} data:; font-src {own} data:"
    )
    return page.replace("<head>", f'<head>\n<meta http-equiv="Content-Security-Policy" content="{told}">', 1)


def _digests(texts: Iterable[str]) -> str:
    found = (base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() for text in texts)
    return " ".join(f"'sha256-{digest}'" for digest in found)
