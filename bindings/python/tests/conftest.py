import numpy as np
import pytest


@pytest.fixture
def triangle():
    """A triangle in the plane. Half-edges 0, 2 and 4 run around its inside."""
    return {
        "origin": np.array([0, 1, 1, 2, 2, 0]),
        "twin": np.array([1, 0, 3, 2, 5, 4]),
        "next": np.array([2, 5, 4, 1, 0, 3]),
    }


def planar_grid(n):
    """A PlanarEmbedding of an n by n grid with diagonals, made without a search for an embedding."""
    import networkx as nx

    embedding = nx.PlanarEmbedding()
    steps = [(1, 0), (1, 1), (0, 1), (-1, 0), (-1, -1), (0, -1)]
    data = {}
    for i in range(n):
        for j in range(n):
            around = [(i + a, j + b) for a, b in steps if 0 <= i + a < n and 0 <= j + b < n]
            data[i * n + j] = [a * n + b for a, b in reversed(around)]
    embedding.set_data(data)
    return embedding
