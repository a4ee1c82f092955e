s/^step = .*/step = "3e-3 s"/
$a [nonlocal_softening]\nlength = "0.6 m"
